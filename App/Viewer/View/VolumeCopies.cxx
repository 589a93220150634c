#include "Viewer/View/VolumeCopies.h"

#include "Viewer/Model/Study.h"

#include <algorithm>

namespace varimarch
{

vtkSmartPointer<vtkImageData> VolumeCopies::Of(const LoadedVolume& volume)
{
  this->ForgetReleased();
  const auto known = std::find_if(this->copies.begin(), this->copies.end(),
    [&](const Copy& one) { return one.source == volume.image; });
  if (known != this->copies.end())
  {
    return known->copy;
  }
  this->copies.push_back({ volume.image, SharedCopy(volume) });
  return this->copies.back().copy;
}

// Nobody else holds a source with one reference, so that its voxels are not needed any more.
void VolumeCopies::ForgetReleased()
{
  this->copies.erase(std::remove_if(this->copies.begin(), this->copies.end(),
                       [](const Copy& one) { return one.source->GetReferenceCount() == 1; }),
    this->copies.end());
}

}
