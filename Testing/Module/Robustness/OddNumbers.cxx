#include "Module/Robustness/OddNumbers.h"

#include "Module/Scenes/UsualSettings.h"
#include "Support/ExpectedVtkErrors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

vtkSmartPointer<vtkImageData> ValuesOfBall()
{
  constexpr int Side = 9;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  image->SetOrigin(-4.0, -4.0, -4.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int z = 0; z < Side; ++z)
  {
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        const double radius = std::hypot(x - 4.0, y - 4.0, z - 4.0);
        image->SetScalarComponentFromDouble(x, y, z, 0, std::max(6.0 - radius, 0.0));
      }
    }
  }
  return image;
}

bool AreFinite(const std::vector<float>& pixels)
{
  return std::all_of(
    pixels.begin(), pixels.end(), [](float number) { return std::isfinite(number); });
}

}

LitBall::LitBall(vtkHeadlessRenderWindow* window)
  : MapperScene(ValuesOfBall(), 16, window)
{
  this->colors->RemoveAllPoints();
  this->colors->AddRGBPoint(0.0, 0.9, 0.6, 0.3);
  this->opacities->RemoveAllPoints();
  this->opacities->AddPoint(2.0, 0.0);
  this->opacities->AddPoint(5.0, 0.6);
  vtkVolumeProperty* const property = this->volume->GetProperty();
  property->ShadeOn();
  property->SetSpecular(0.3);
  this->renderer->AutomaticLightCreationOff();
  this->head->SetLightTypeToHeadlight();
  this->head->SetIntensity(0.2);
  this->renderer->AddLight(this->head);
  this->lamp = AddLight(this->renderer, { -20.0, -20.0, 20.0 }, { 0.0, 0.0, 0.0 });
  this->lamp->PositionalOn();
  this->lamp->SetConeAngle(60.0);
}

bool IsEmpty(const std::vector<float>& pixels)
{
  return std::all_of(pixels.begin(), pixels.end(), [](float number) { return number == 0.0f; });
}

DrawnByBoth OddScenes::Draw(const std::function<void(LitBall&)>& make)
{
  return this->Draw(make, false);
}

DrawnByBoth OddScenes::DrawTwice(const NamedChange& change)
{
  return this->Draw(change.make, true);
}

DrawnByBoth OddScenes::Draw(const std::function<void(LitBall&)>& make, bool isTwice)
{
  DrawnByBoth drawn;
  for (const bool byPackets : { true, false })
  {
    LitBall scene(this->window);
    make(scene);
    const ExpectedVtkErrors errors;
    const auto draw = [&] { return byPackets ? scene.DrawByProcessor() : scene.Draw(); };
    drawn.images.push_back(draw());
    const std::string text = errors.Text();
    drawn.text += text;
    if (isTwice)
    {
      draw();
      EXPECT_EQ(errors.Text(), text) << "said again";
    }
  }
  return drawn;
}

void ExpectFinite(const DrawnByBoth& drawn, const std::string& name)
{
  for (const std::vector<float>& image : drawn.images)
  {
    EXPECT_TRUE(AreFinite(image)) << name;
  }
}
