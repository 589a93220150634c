#include "ReferenceSet.h"

namespace varimarch
{

namespace
{

constexpr int SideOfPictures = 64;

Scene SceneOf(ProceduralKind kind, const std::array<int, 3>& dimensions)
{
  Scene scene;
  scene.volume = ProceduralSource{ kind, dimensions, 1 };
  scene.camera.azimuthDegrees = 25.0;
  scene.camera.elevationDegrees = 15.0;
  scene.size = { SideOfPictures, SideOfPictures };
  scene.look.shading.enabled = false;
  return scene;
}

// Values from 0 to 255: the specifications' test volumes.
Scene TestVolume(ProceduralKind kind)
{
  Scene scene = SceneOf(kind, { 17, 17, 17 });
  scene.look.colors = { { 0.0, { 0.9, 0.3, 0.1 }, {} }, { 255.0, { 0.1, 0.5, 1.0 }, {} } };
  scene.look.opacities = { { 0.0, 0.004, {} }, { 255.0, 0.04, {} } };
  return scene;
}

Scene ShellsOf(const std::vector<OpacityNode>& opacities)
{
  Scene scene = SceneOf(ProceduralKind::Shells, { 40, 40, 40 });
  scene.look.colors = { { 60.0, { 0.2, 0.45, 0.7 }, {} }, { 240.0, { 0.95, 0.55, 0.2 }, {} } };
  scene.look.opacities = opacities;
  return scene;
}

Scene MarschnerLobbSurface(Blend blend)
{
  Scene scene = SceneOf(ProceduralKind::MarschnerLobb, { 32, 32, 32 });
  scene.look.colors = { { 0.5, { 0.85, 0.8, 0.7 }, {} } };
  scene.look.opacities = { { 0.48, 0.0, {} }, { 0.52, 0.9, {} } };
  scene.look.isosurfaces = { { 0.5, { 0.85, 0.8, 0.7 }, 1.0 } };
  scene.look.blend = blend;
  scene.look.shading.enabled = true;
  scene.camera.view = View::Superior;
  scene.camera.elevationDegrees = -40.0;
  return scene;
}

Scene TorsoBy(Blend blend, const std::vector<OpacityNode>& opacities)
{
  Scene scene = SceneOf(ProceduralKind::Torso, { 40, 36, 24 });
  scene.look.colors = { { -200.0, { 0.8, 0.5, 0.4 }, {} }, { 150.0, { 0.9, 0.3, 0.2 }, {} },
    { 400.0, { 1.0, 0.95, 0.85 }, {} } };
  scene.look.opacities = opacities;
  scene.look.blend = blend;
  return scene;
}

const std::vector<OpacityNode> soft = { { -200.0, 0.0, {} }, { 0.0, 0.01, {} }, { 150.0, 0.01, {} },
  { 400.0, 0.2, {} } };
const std::vector<OpacityNode> bone = { { 150.0, 0.0, {} }, { 250.0, 0.5, {} } };
const std::vector<OpacityNode> rising = { { -1000.0, 0.0, {} }, { 1200.0, 1.0, {} } };

Scene Lit(Scene scene)
{
  scene.look.shading.enabled = true;
  return scene;
}

Scene Parallel(Scene scene)
{
  scene.camera.parallel = true;
  return scene;
}

// From the spine into the chest.
Scene Inside(Scene scene)
{
  scene.camera.viewAngleDegrees = 60.0;
  scene.camera.pose =
    CameraPose{ { 5.0, -20.0, 10.0 }, { 0.0, 40.0, 0.0 }, { 0.0, 0.0, 1.0 }, 100.0 };
  return scene;
}

}

std::vector<JudgedScene> JudgedScenes()
{
  const Scene torso = TorsoBy(Blend::Composite, soft);
  return {
    { "ramp", TestVolume(ProceduralKind::Ramp) },
    { "checkerboard", TestVolume(ProceduralKind::Checkerboard) },
    { "shells-hard-edge",
      ShellsOf({ { 89.0, 0.0, {} }, { 90.0, 0.08, {} }, { 240.0, 0.08, {} } }) },
    { "shells-thin-peak",
      ShellsOf({ { 118.0, 0.0, {} }, { 120.0, 0.9, {} }, { 122.0, 0.0, {} } }) },
    { "marschner-lobb-steep", MarschnerLobbSurface(Blend::Composite) },
    { "marschner-lobb-isosurface", MarschnerLobbSurface(Blend::Isosurface) },
    { "torso-soft", torso },
    { "torso-soft-lit", Lit(torso) },
    { "torso-bone-lit", Lit(TorsoBy(Blend::Composite, bone)) },
    { "torso-parallel", Parallel(torso) },
    { "torso-inside", Inside(torso) },
    { "torso-maximum", TorsoBy(Blend::MaximumIntensity, rising) },
    { "torso-average", TorsoBy(Blend::AverageIntensity, rising) },
    { "torso-additive", TorsoBy(Blend::Additive, { { -500.0, 0.0, {} }, { 500.0, 0.01, {} } }) },
  };
}

}
