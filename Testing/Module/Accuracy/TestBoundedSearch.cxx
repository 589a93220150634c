// Error tolerances that light takes too long for, and drawings that are stopped.

#include "Module/Scenes/MapperScene.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace varimarch;

namespace
{

/// Bands of matter that occlude each other, of which steps can miss some at any length.
class OccludedBands : public MapperScene
{
public:
  OccludedBands()
    : MapperScene(Values(), 32)
  {
    this->colors->RemoveAllPoints();
    this->colors->AddRGBPoint(0.0, 0.9, 0.6, 0.3);
    this->opacities->RemoveAllPoints();
    for (int band = 0; band < 4; ++band)
    {
      this->opacities->AddPoint(2.0 * band, 0.0);
      this->opacities->AddPoint(2.0 * band + 1.0, 0.4);
    }
    this->volume->GetProperty()->ShadeOn();
    this->mapper->ProcessorMarchingOn();
    this->mapper->SetAmbientOcclusion(1.0);
  }

private:
  static vtkSmartPointer<vtkImageData> Values()
  {
    constexpr int Side = 9;
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(Side, Side, Side);
    image->AllocateScalars(VTK_FLOAT, 1);
    for (int z = 0; z < Side; ++z)
    {
      for (int y = 0; y < Side; ++y)
      {
        for (int x = 0; x < Side; ++x)
        {
          image->SetScalarComponentFromDouble(
            x, y, z, 0, std::hypot(x - 3.7, y - 4.1, z - 4.4) + std::sin(x + 2.0 * y));
        }
      }
    }
    return image;
  }
};

/// Calls a function at each event of a kind.
class Observer
{
public:
  Observer(vtkObject* subject, unsigned long event, std::function<void(void*)> react)
    : react(std::move(react))
  {
    this->command->SetClientData(this);
    this->command->SetCallback([](vtkObject*, unsigned long, void* observer, void* data)
      { static_cast<Observer*>(observer)->react(data); });
    subject->AddObserver(event, this->command);
  }

private:
  std::function<void(void*)> react;
  vtkNew<vtkCallbackCommand> command;
};

// Steps so short that the light of one image takes much longer than the checks are apart.
void UseShortSteps(OccludedBands& scene)
{
  scene.mapper->SetErrorTolerance(0.0);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(1.0 / 24.0);
}

bool IsEmpty(const std::vector<float>& pixels)
{
  return std::all_of(pixels.begin(), pixels.end(), [](float number) { return number == 0.0f; });
}

}

TEST(BoundedSearch, SaysThatATinyToleranceIsNotReached)
{
  OccludedBands scene;
  scene.mapper->SetErrorTolerance(1e-9);
  const ExpectedVtkErrors warnings;
  const std::vector<float> drawn = scene.Draw();
  EXPECT_FALSE(scene.mapper->GetErrorToleranceIsKept());
  EXPECT_GT(scene.mapper->GetEstimatedError(), 1e-9);
  EXPECT_NE(warnings.Text().find("The error tolerance 1e-09"), std::string::npos)
    << warnings.Text();
  EXPECT_FALSE(IsEmpty(drawn));

  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 1) << "the search is not repeated";
}

TEST(BoundedSearch, IsCloseToTheImageOfAToleranceThatIsReached)
{
  OccludedBands scene;
  scene.mapper->SetErrorTolerance(1e-9);
  const ExpectedVtkErrors warnings;
  const std::vector<float> drawn = scene.Draw();
  const double error = scene.mapper->GetEstimatedError();
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  const std::vector<float> reached = scene.Draw();
  double largest = 0.0;
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    largest = std::max(largest, double(std::abs(drawn[i] - reached[i])));
  }
  EXPECT_LT(largest, 2.0 / 64.0 + error);
}

TEST(BoundedSearch, EndsAtTheSameStepsEachTime)
{
  double distancesMm[2];
  for (double& distanceMm : distancesMm)
  {
    OccludedBands scene;
    scene.mapper->SetErrorTolerance(1e-9);
    const ExpectedVtkErrors warnings;
    scene.Draw();
    distanceMm = scene.mapper->GetUsedSampleDistance();
  }
  EXPECT_EQ(distancesMm[0], distancesMm[1]);
}

TEST(StoppedDrawing, LeavesAnImageOfDearLightAtOnce)
{
  OccludedBands scene;
  UseShortSteps(scene);
  int checks = 0;
  const Observer stop(scene.window, vtkCommand::AbortCheckEvent,
    [&](void*)
    {
      ++checks;
      scene.window->SetAbortRender(1);
    });
  EXPECT_TRUE(IsEmpty(scene.Draw())) << "the image was drawn to its end";
  EXPECT_GT(checks, 0);
}

TEST(StoppedDrawing, IsToldHowMuchIsDone)
{
  OccludedBands scene;
  UseShortSteps(scene);
  scene.mapper->Update(); // which is told too
  std::vector<double> parts;
  const Observer observer(scene.mapper, vtkCommand::ProgressEvent,
    [&](void* part) { parts.push_back(*static_cast<double*>(part)); });
  scene.Draw();
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  const auto isBetween = [](double part) { return 0.5 < part && part < 1.0; };
  EXPECT_GT(std::count_if(parts.begin(), parts.end(), isBetween), 2);
}
