#ifndef Varimarch_Viewer_VtkPictures_h
#define Varimarch_Viewer_VtkPictures_h

#include <QImage>

class vtkImageData;

namespace varimarch
{

/// Conversions of VTK images, whose first row is the lowest, to QImage.

/// @param picture  bytes of RGB
QImage ImageOfBytes(vtkImageData* picture);

/// @param picture  floats of premultiplied RGBA
QImage ImageOfFloats(vtkImageData* picture);

}

#endif
