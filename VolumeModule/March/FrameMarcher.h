#ifndef Varimarch_March_FrameMarcher_h
#define Varimarch_March_FrameMarcher_h

#include "Frame/MarchPlan.h"

#include <cstddef>
#include <exception>
#include <vector>

class vtkWindow;

namespace varimarch
{

/// The end of a drawing that an observer of the window's vtkCommand::AbortCheckEvent has stopped,
/// which is no error: the image is not wanted any more.
class DrawingStopped : public std::exception
{
public:
  const char* what() const noexcept override { return "The drawing was stopped"; }
};

/// Interface for marching the rays of a frame, once its resources are updated. The implementations
/// are shaders on the graphics device, and packets of rays on the processor.
class FrameMarcher
{
public:
  virtual ~FrameMarcher() = default;

  /// Marches the rays of the plan's viewport and draws their colours, or the other output of the
  /// plan's pass, into the current framebuffer.
  /// @throws std::runtime_error if there is no memory, or a shader cannot be compiled
  virtual void Draw(const Frame& frame, const MarchPlan& plan) = 0;

  /// Marches trial images without changing the current framebuffer.
  /// @param plans  those of images that differ in their sample distances only
  /// @return premultiplied RGBA of the pixels of the viewport of each plan
  virtual std::vector<std::vector<float>> DrawTrials(
    const Frame& frame, const std::vector<MarchPlan>& plans) = 0;

  virtual std::size_t Bytes() const = 0; ///< The graphics memory of this marcher.
  virtual void Release(vtkWindow* window) = 0;
};

}

#endif
