#include "Viewer/View/ByteImage.h"

#include <vtkImageData.h>

namespace varimarch
{

QImage ImageOf(vtkImageData* bytePicture)
{
  const int* const size = bytePicture->GetDimensions();
  return QImage(static_cast<const uchar*>(bytePicture->GetScalarPointer()), size[0], size[1],
    3 * size[0], QImage::Format_RGB888)
    .mirrored();
}

}
