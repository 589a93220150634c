#ifndef Varimarch_Viewer_ByteImage_h
#define Varimarch_Viewer_ByteImage_h

#include <QImage>

class vtkImageData;

namespace varimarch
{

/// A picture of VTK's in bytes of red, green and blue, whose row 0 is the lowest, as one of Qt's.
QImage ImageOf(vtkImageData* bytePicture);

}

#endif
