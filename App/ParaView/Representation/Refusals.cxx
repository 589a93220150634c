#include "Refusals.h"

#include "Core/Blocks/OwnerOrder.h"

#include "vtkVolumeMapper.h"

namespace varimarch
{

namespace
{

// True for blend modes whose parts of a ray can be laid over each other.
bool IsComposite(int blendMode)
{
  return blendMode == vtkVolumeMapper::COMPOSITE_BLEND ||
    blendMode == vtkVolumeMapper::ISOSURFACE_BLEND || blendMode == vtkVolumeMapper::SLICE_BLEND;
}

}

std::string ProblemOfRequest(const Request& request, const std::vector<OwnedPart>& parts)
{
  const bool isDivided = request.isShared || parts.size() > 1;
  if (isDivided && !IsComposite(request.blendMode))
  {
    return std::string("The blend mode is ") + std::to_string(request.blendMode) +
      ", whose value of a pixel needs the whole ray, but several processes or images have a part "
      "of it each: expected composite (0), isosurface (5) or slice (6), or one process and one "
      "image";
  }
  if (isDivided && request.dimsLight)
  {
    return "Shadows, ambient occlusion or scattering are on, but a process or image does not have "
           "the parts of the volume between its own and a light: expected them to be off, or one "
           "process and one image";
  }
  if (request.hasSeveral && request.isCropped && request.isShared)
  {
    return "Cropping is on, but a process does not know the whole of which its images are a part: "
           "expected no cropping, one process, or an image that a reader has divided";
  }
  return std::string();
}

std::string ProblemOfParts(const std::vector<OwnedPart>& parts)
{
  const auto overlap = FirstOverlap(BoxesOf(parts));
  return !overlap ? std::string()
                  : "The images " + std::to_string(overlap->first + 1) + " and " +
      std::to_string(overlap->second + 1) +
      " of the input overlap, so that no order to draw them in is right: expected images that "
      "touch at most; extract one of them, or choose ParaView's \"Volume\"";
}

}
