#ifndef Varimarch_Testing_RegressionCase_h
#define Varimarch_Testing_RegressionCase_h

#include "Module/Scenes/MapperScene.h"
#include "Module/Scenes/OverlapScene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// Height of the pictures [pixels].
inline constexpr int RegressionSide = 96;

/// A scene ready to be drawn, and the image that it should show. All that its functions capture
/// must be in `volumes` and `overlap`, or live as long as they do.
struct RegressionScene
{
  std::array<int, 2> size = { RegressionSide, RegressionSide }; ///< [pixels]
  std::vector<std::shared_ptr<MapperScene>> volumes;            ///< in the window of the first
  std::shared_ptr<OverlapScene> overlap;                        ///< instead of volumes

  /// The reference's image: premultiplied RGBA without the background, the bottom row first.
  std::function<std::vector<float>()> truth;
  std::array<double, 3> background = { 0.15, 0.2, 0.3 };

  /// The drawn image as bytes RGB if it is not in the window; otherwise empty.
  std::function<vtkSmartPointer<vtkImageData>()> drawn = {};

  vtkHeadlessRenderWindow* Window() const;
};

/// A regression test. Its name is that of its baseline.
struct RegressionCase
{
  std::string name;
  std::function<RegressionScene()> make;

  /// 99.9 % of the pixels may be off by this [1/255]. Default: the mapper's error tolerance of 4,
  /// and the rounding of picture and baseline to bytes.
  double allowed999 = 5.0;

  /// A part of the warning by which the mapper may refuse to draw the scene with shaders. A picture
  /// that is refused must differ from the baseline. Empty: the mapper draws it.
  std::string refusal = {};
};

/// The refusal of shaders without a graphics card.
constexpr const char* TooManySegments =
  "without a graphics card OpenGL ends the short segments of rays to lights";

/// All pictures, by sections of Documentation/FeatureTable.md.
std::vector<RegressionCase> InputCases();
std::vector<RegressionCase> BlendCases();
std::vector<RegressionCase> LightCases();
std::vector<RegressionCase> ShadowCases(); ///< Opaque geometry beside a volume.
std::vector<RegressionCase> CutCases();
std::vector<RegressionCase> SceneCases();
std::vector<RegressionCase> ImageCases();
std::vector<RegressionCase> AllRegressionCases();

/// A scene with the mapper's defaults.
std::shared_ptr<MapperScene> NewScene(vtkImageData* image, int side = RegressionSide);

/// The scene of one volume whose truth is MapperScene::Truth.
RegressionScene SceneOf(const std::shared_ptr<MapperScene>& volume);

/// The scene of one volume whose truth is the composite of a material.
RegressionScene SceneOf(
  const std::shared_ptr<MapperScene>& volume, const MapperScene::Material& material);

/// A case of the small torso, which `prepare` changes, whose truth is MapperScene::Truth.
RegressionCase TorsoCase(const std::string& name, std::function<void(MapperScene&)> prepare);

/// A case of the small torso whose truth is the composite of a material.
RegressionCase MaterialCase(const std::string& name, std::function<void(MapperScene&)> prepare,
  std::function<MapperScene::Material(MapperScene&)> material);

/// Composites premultiplied RGBA of as many pixels, front over back.
std::vector<float> ImageOver(const std::vector<float>& front, const std::vector<float>& back);

#endif
