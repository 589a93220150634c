#ifndef Varimarch_Scene_StopCheck_h
#define Varimarch_Scene_StopCheck_h

#include <vtkNew.h>

#include <functional>

class vtkCallbackCommand;
class vtkRenderWindow;

namespace varimarch
{

/// Stops what a window draws, during a search for the steps that keep a tolerance, once a function
/// says so, for the lifetime of this object. The window asks a few times per second. A drawing that
/// was stopped leaves no image.
class StopCheck
{
public:
  /// @param window    which outlives this object
  /// @param isWanted  may make another context current
  StopCheck(vtkRenderWindow* window, std::function<bool()> isWanted);
  ~StopCheck();
  StopCheck(const StopCheck&) = delete;
  StopCheck& operator=(const StopCheck&) = delete;

private:
  void Check();

  vtkRenderWindow* window;
  std::function<bool()> isWanted;
  vtkNew<vtkCallbackCommand> command;
};

}

#endif
