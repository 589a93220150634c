#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "ReferenceSet.h"

namespace varimarch
{

void RunReferences(const ReferencesArguments& arguments)
{
  SetInterruptNotice(OutputFolder(arguments.outputFolder), "some of the images");
  Progress progress("Drawing the scenes of the references");
  const auto onStep = [&](const std::string& step) { progress.SetActivity(step); };
  arguments.renderer ? WritePicturesOf(*arguments.renderer, arguments.outputFolder, onStep)
                     : WriteReferences(arguments.outputFolder, onStep);
}

}
