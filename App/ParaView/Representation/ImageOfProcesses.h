#ifndef Varimarch_ImageOfProcesses_h
#define Varimarch_ImageOfProcesses_h

#include "vtkNew.h"

#include <string>

class vtkMultiProcessController;
class vtkRenderer;
class vtkVarimarchFloatPass;

namespace varimarch
{

struct OwnerOrder;

/// The image that one process draws, or several together: the numbers in which it is drawn, and the
/// order in which ParaView lays the pictures of processes over each other. A view needs one, of any
/// of its volumes.
class ImageOfProcesses
{
public:
  ImageOfProcesses();
  ~ImageOfProcesses();

  /// True if the image that a renderer begins may be drawn in floats: a still one of colours, which
  /// ParaView shows in one window, without several samples in a pixel, and draws in its usual way.
  static bool MayBeInFloats(vtkRenderer* renderer);

  /// Orders the pictures of the image that a renderer begins. All processes must call this.
  /// @param order     the result of OrderOfProcesses
  /// @param inFloats  true to composite in floats instead of bytes; needs MayBeInFloats
  /// @return  a warning at the first image for which no order is right; empty at others
  std::string Begin(vtkRenderer* renderer, vtkMultiProcessController* controller,
    const OwnerOrder& order, bool inFloats);

  /// Draws the image that a renderer begins in floats, without other processes. Needs
  /// MayBeInFloats.
  void BeginAlone(vtkRenderer* renderer);

  /// A file for the pixels of images in floats; see vtkVarimarchFloatPass.
  void SetFile(const std::string& file);

  /// Ends the image that Begin or BeginAlone has begun, if any.
  void End();

private:
  vtkNew<vtkVarimarchFloatPass> floatPass;
  bool hasWarned = false;
};

}

#endif
