#include "Scene/StopCheck.h"

#include <vtkCallbackCommand.h>
#include <vtkRenderWindow.h>

#include <utility>

namespace varimarch
{

StopCheck::StopCheck(vtkRenderWindow* window, std::function<bool()> isWanted)
  : window(window)
  , isWanted(std::move(isWanted))
{
  this->command->SetClientData(this);
  this->command->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<StopCheck*>(self)->Check(); });
  window->SetAbortRender(0);
  window->AddObserver(vtkCommand::AbortCheckEvent, this->command);
}

StopCheck::~StopCheck()
{
  this->window->RemoveObserver(this->command);
  this->window->SetAbortRender(0);
}

void StopCheck::Check()
{
  if (!this->isWanted())
  {
    this->window->SetAbortRender(1);
  }
  this->window->MakeCurrent();
}

}
