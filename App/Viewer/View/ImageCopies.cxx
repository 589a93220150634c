#include "Viewer/View/ImageCopies.h"

#include <algorithm>
#include <utility>

namespace varimarch
{

void ImageCopies::Begin()
{
  this->before = std::exchange(this->used, {});
}

// A copy that is no longer needed keeps the voxels of its volume.
void ImageCopies::End()
{
  this->before.clear();
}

vtkSmartPointer<vtkImageData> ImageCopies::Of(vtkImageData* source, int version, const Make& make)
{
  const auto known = std::find_if(this->before.begin(), this->before.end(),
    [&](const Copy& one) { return one.source == source && one.version == version; });
  this->used.push_back({ source, version, known == this->before.end() ? make() : known->copy });
  return this->used.back().copy;
}

}
