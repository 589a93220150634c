#ifndef Varimarch_Scene_LookChannels_h
#define Varimarch_Scene_LookChannels_h

#include "Readers/VolumeFile.h"
#include "Scene/Scene.h"

#include <vector>

namespace varimarch
{

/// The settings of all channels of a volume: those given, and for each further one its name and its
/// colour, or else one of four colours that are told apart.
std::vector<LookChannel> WithAllChannels(
  std::vector<LookChannel> given, const std::vector<VolumeChannel>& channels);

/// The look of one channel: the curves in its window, its colour, and no opacity if it is not
/// visible. A channel without settings has the curves as they are.
Look LookOfChannel(const Look& look, std::size_t channel);

}

#endif
