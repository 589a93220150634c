#include "Readers/Parsing/VtkProgress.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>

namespace varimarch
{

void UpdateWithProgress(vtkAlgorithm* algorithm, ReadProgress& progress)
{
  struct Link
  {
    ReadProgress& progress;
    bool cancelled;
  } link{ progress, false };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&link);
  // VTK's code is not exception-safe, so the algorithm is asked to abort first.
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* clientData, void* partDone)
    {
      auto* link = static_cast<Link*>(clientData);
      try
      {
        link->progress.Report(*static_cast<double*>(partDone));
      }
      catch (const ReadCancelled&)
      {
        link->cancelled = true;
        vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
      }
    });
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ProgressEvent, observer);
  algorithm->Update(0);
  algorithm->RemoveObserver(tag);
  if (link.cancelled)
  {
    throw ReadCancelled();
  }
}

}
