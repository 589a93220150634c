#ifndef Varimarch_Viewer_VtkPictures_h
#define Varimarch_Viewer_VtkPictures_h

#include <QImage>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// Conversions between VTK images, whose first row is the lowest, and QImage.

/// @param picture  bytes of RGB
QImage ImageOfBytes(vtkImageData* picture);

/// @param picture  floats of premultiplied RGBA
QImage ImageOfFloats(vtkImageData* picture);

/// Bytes of RGB, or of RGBA for an image with an alpha channel, not premultiplied.
vtkSmartPointer<vtkImageData> BytesOfImage(const QImage& image);

}

#endif
