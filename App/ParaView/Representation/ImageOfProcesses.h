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

/// The image that several processes draw together: the order in which ParaView lays their pictures
/// over each other, and the numbers in which it does so. A view needs one, of any of its volumes.
class ImageOfProcesses
{
public:
  ImageOfProcesses();
  ~ImageOfProcesses();

  /// Orders the pictures of the image that a renderer begins. All processes must call this.
  /// @param order     the result of OrderOfProcesses
  /// @param inFloats  true to composite still images in floats instead of bytes, where ParaView
  ///                  shows one image in one window
  /// @return  a warning at the first image for which no order is right; empty at others
  std::string Begin(vtkRenderer* renderer, vtkMultiProcessController* controller,
    const OwnerOrder& order, bool inFloats);

  /// Ends the image that Begin has begun, if any.
  void End();

private:
  vtkNew<vtkVarimarchFloatPass> floatPass;
  bool hasWarned = false;
};

}

#endif
