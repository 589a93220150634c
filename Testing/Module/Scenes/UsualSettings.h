#ifndef Varimarch_Testing_UsualSettings_h
#define Varimarch_Testing_UsualSettings_h

#include "Module/Scenes/MapperScene.h"

#include <glm/vec3.hpp>

class vtkLight;

// Lights and cuts that several tests have in common.

/// Adds a light that stays where it is in the world.
vtkLight* AddLight(vtkRenderer* renderer, glm::dvec3 position, glm::dvec3 focus);

/// Replaces all lights by a yellow one at infinity and a positional one beside the torso, which has
/// blue highlights.
void UseSunAndLamp(vtkRenderer* renderer);

/// Gives a scene their light, with highlights, and shadows.
void CastShadowsOfSunAndLamp(MapperScene& scene);

/// Crops each axis to the middle half of the image's bounds, off all voxels.
/// @param flags  regions to draw, as for vtkVolumeMapper::SetCroppingRegionFlags
void CropToMiddle(MapperScene& scene, int flags);

#endif
