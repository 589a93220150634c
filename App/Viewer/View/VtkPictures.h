#ifndef Varimarch_Viewer_VtkPictures_h
#define Varimarch_Viewer_VtkPictures_h

#include <QImage>

class vtkImageData;

namespace varimarch
{

/// Pictures of VTK's, whose row 0 is the lowest, as those of Qt.

/// @param picture  bytes of red, green and blue
QImage ImageOfBytes(vtkImageData* picture);

/// @param picture  floats of red, green, blue and opacity, which the colours are multiplied by
QImage ImageOfFloats(vtkImageData* picture);

}

#endif
