#ifndef Varimarch_Scene_SceneLights_h
#define Varimarch_Scene_SceneLights_h

#include "Scene/Model/Scene.h"

#include <vector>

class vtkRenderer;

namespace varimarch
{

/// The largest number of lights in a scene, for which VTK's GPU mapper has room too.
constexpr std::size_t MostLights = 6;

constexpr double LargestSoftnessDegrees = 60.0;

/// The direction towards a far light. Camera: 0, 0 is towards the eye, and positive angles lead to
/// the right and upwards in the image. Directional: 0, 0 is in front of the patient, and positive
/// angles lead to the patient's left and to the head.
struct LightAngles
{
  double azimuthDegrees;   ///< [-180, 180]
  double elevationDegrees; ///< [-90, 90]
};

LightAngles AnglesOf(const std::array<double, 3>& direction, LightKind kind);
std::array<double, 3> DirectionOf(const LightAngles& angles, LightKind kind);

/// A far light that turns with the camera.
/// @param azimuthDegrees    to the right of the eye
/// @param elevationDegrees  above it
SceneLight CameraLight(double azimuthDegrees, double elevationDegrees);

/// The light of a scene, for others, and that of others for a scene.
Lighting LightingOf(const Scene& scene);
void TakeLighting(const Lighting& lighting, Scene& scene);

/// Replaces the lights of a renderer. Without any it makes its own, a white light at the eye. The
/// ambient light of all lights together is white, so that a look's ambient coefficient means the
/// same under any lights. With a light that is not at the eye, only the sides where the values fall
/// are lit; otherwise a light from the right would light the left as well.
void SetLights(const std::vector<SceneLight>& lights, vtkRenderer* renderer);

}

#endif
