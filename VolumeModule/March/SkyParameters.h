#ifndef Varimarch_March_SkyParameters_h
#define Varimarch_March_SkyParameters_h

#include "Core/Packets/PacketScene.h"
#include "Core/Parameters/MarchParameters.h"
#include "Frame/MarchPlan.h"

namespace varimarch
{

/// Sets the parameters of ambient occlusion, if the march has any.
void SetSky(VolumeParameters& parameters, const VolumeMarch& march, const PacketSky& sky);

/// True if a ray may have more places than can be traced to all sides, because the device ends
/// shaders that take longer.
bool HasFewSkyPlaces(const VolumeMarch& march, const PacketSky& sky);

/// The shortest sample distance that the marcher supports [mm]: ShortestSampleDistanceMm, or four
/// times as much where the device ends long shaders and three quarters of one are for ambient
/// occlusion.
double ShortestDistanceWithSkyMm(const Frame& frame, Marcher marcher);

/// The iterations of loops that a software rasteriser allows for shadows, and for ambient
/// occlusion.
double MostIterationsOfLight(const RenderSettings& settings);

}

#endif
