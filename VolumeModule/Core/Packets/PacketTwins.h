#ifndef Varimarch_Core_Packets_PacketTwins_h
#define Varimarch_Core_Packets_PacketTwins_h

#include <set>
#include <string>

namespace varimarch
{

/// The shader files that packets of rays repeat in lanes, as paths below VolumeModule/Shaders. Each
/// header that repeats some names them in a line "Twin of ..." of its first comment, from which
/// MakeTwins.cmake writes the source file while building.
const std::set<std::string>& ShaderFilesOfPackets();

}

#endif
