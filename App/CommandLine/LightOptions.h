#ifndef Varimarch_CommandLine_LightOptions_h
#define Varimarch_CommandLine_LightOptions_h

#include "SceneArguments.h"

namespace CLI
{
class App;
}

namespace varimarch
{

/// Adds the options of lights, and of how matter takes and scatters light.
void AddLightOptions(CLI::App& command, SceneArguments& arguments);

}

#endif
