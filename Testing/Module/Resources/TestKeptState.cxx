// Images do not show what a mapper keeps from earlier ones. Testing/State tries all setters; here
// are those whose fault it takes a certain order of calls to see.

#include "Module/Scenes/MapperScene.h"
#include "Module/Scenes/UnevenGrid.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace
{

using Step = std::function<void(MapperScene& scene)>;

constexpr int PictureSide = 24; // pixels

// Expects that a change makes another image, and the same whether there was one before or not.
void ExpectImageOfNewMapper(const Step& arrange, const Step& change)
{
  MapperScene kept(SmallTorso(), PictureSide);
  arrange(kept);
  const std::vector<float> before = kept.Draw();
  change(kept);
  const std::vector<float> after = kept.Draw();
  MapperScene fresh(kept.image, PictureSide);
  arrange(fresh);
  change(fresh);
  EXPECT_EQ(after, fresh.Draw());
  EXPECT_NE(after, before);
}

void UseFixedSteps(MapperScene& scene)
{
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(1.0);
}

}

// The colours' time is that of the newest function, and the opacities are newer than both colours.
TEST(KeptState, DoesNotShowInAGrayFunctionThatWasSetBefore)
{
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(-1000.0, 1.0);
  gray->AddPoint(1000.0, 0.0);
  ExpectImageOfNewMapper(
    [&](MapperScene& scene)
    {
      UseFixedSteps(scene);
      scene.volume->GetProperty()->SetColor(gray);
      scene.volume->GetProperty()->SetColor(scene.colors);
      scene.opacities->Modified();
    },
    [&](MapperScene& scene) { scene.volume->GetProperty()->SetColor(gray); });
}

// The array is newer than both images, so that their times are the same.
TEST(KeptState, DoesNotShowInAnImageOfOtherDimensionsWithTheSameArray)
{
  vtkNew<vtkImageData> turned;
  ExpectImageOfNewMapper(
    [&](MapperScene& scene)
    {
      UseFixedSteps(scene);
      turned->SetDimensions(36, 40, 24);
      turned->SetSpacing(scene.image->GetSpacing());
      turned->GetPointData()->SetScalars(scene.image->GetPointData()->GetScalars());
      scene.image->GetPointData()->GetScalars()->Modified();
    },
    [&](MapperScene& scene) { scene.mapper->SetInputData(turned); });
}

// A grid does not report it when its coordinates change.
TEST(KeptState, OfAccumulatedImagesEndsWithCoordinatesInPlace)
{
  const Places places = { UnevenPlaces(12, 40.0, 1.5), UnevenPlaces(12, 40.0, 1.2),
    UnevenPlaces(12, 40.0, 1.0) };
  MapperScene scene(EvenImage(places), PictureSide);
  const auto grid = WaveGrid(places);
  scene.mapper->SetInputData(grid);
  scene.mapper->SetMaximumAccumulatedPictures(4);
  scene.window->Render();
  scene.window->Render();
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 2);
  vtkDataArray* const coordinates = grid->GetXCoordinates();
  coordinates->SetComponent(5, 0, coordinates->GetComponent(5, 0) + 0.5);
  coordinates->Modified();
  scene.window->Render();
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 1);
}
