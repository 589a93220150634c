#ifndef Varimarch_Testing_OddNumbers_h
#define Varimarch_Testing_OddNumbers_h

#include "Module/Scenes/MapperScene.h"

#include <vtkHeadlessRenderWindow.h>
#include <vtkLight.h>
#include <vtkNew.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

// A scene for numbers without a meaning, and its images by both marchers.

inline constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
inline constexpr double Infinite = std::numeric_limits<double>::infinity();

/// A ball in air under a lamp beside it and a head light.
class LitBall : public MapperScene
{
public:
  explicit LitBall(vtkHeadlessRenderWindow* window);

  vtkLight* lamp = nullptr;
  vtkNew<vtkLight> head;
};

/// A change of a scene.
struct NamedChange
{
  std::string name;
  std::function<void(LitBall&)> make;
};

/// The images of a scene by packets and by shaders, and what was said.
struct DrawnByBoth
{
  std::vector<std::vector<float>> images;
  std::string text;
};

/// Draws changed balls in one window, which keeps its shaders.
class OddScenes
{
public:
  DrawnByBoth Draw(const std::function<void(LitBall&)>& make);
  /// Draws twice by each, and expects that nothing is said again for the second images.
  DrawnByBoth DrawTwice(const NamedChange& change);

private:
  DrawnByBoth Draw(const std::function<void(LitBall&)>& make, bool isTwice);

  vtkNew<vtkHeadlessRenderWindow> window;
};

/// Expects that all pixels are finite.
void ExpectFinite(const DrawnByBoth& drawn, const std::string& name);

bool IsEmpty(const std::vector<float>& pixels);

#endif
