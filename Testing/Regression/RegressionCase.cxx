#include "Regression/RegressionCase.h"

#include <utility>

vtkHeadlessRenderWindow* RegressionScene::Window() const
{
  return this->overlap ? this->overlap->window.Get() : this->volumes.front()->window.Get();
}

std::vector<RegressionCase> AllRegressionCases()
{
  std::vector<RegressionCase> all;
  for (const auto& cases : { InputCases(), BlendCases(), LightCases(), ShadowCases(), CutCases(),
         SceneCases(), ImageCases() })
  {
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

std::shared_ptr<MapperScene> NewScene(vtkImageData* image, int side)
{
  const auto scene = std::make_shared<MapperScene>(image, side);
  vtkNew<vtkVariationFieldVolumeMapper> defaults;
  scene->mapper->SetErrorTolerance(defaults->GetErrorTolerance());
  scene->mapper->SetProcessorMarching(defaults->GetProcessorMarching());
  return scene;
}

RegressionScene SceneOf(const std::shared_ptr<MapperScene>& volume)
{
  RegressionScene scene;
  scene.size = { volume->size, volume->size };
  scene.volumes = { volume };
  scene.truth = [volume] { return volume->Truth(); };
  return scene;
}

RegressionScene SceneOf(
  const std::shared_ptr<MapperScene>& volume, const MapperScene::Material& material)
{
  RegressionScene scene = SceneOf(volume);
  scene.truth = [volume, material] { return volume->TruthOf(material); };
  return scene;
}

RegressionCase TorsoCase(const std::string& name, std::function<void(MapperScene&)> prepare)
{
  return { name,
    [prepare = std::move(prepare)]
    {
      const auto scene = NewScene(SmallTorso());
      prepare(*scene);
      return SceneOf(scene);
    } };
}

RegressionCase MaterialCase(const std::string& name, std::function<void(MapperScene&)> prepare,
  std::function<MapperScene::Material(MapperScene&)> material)
{
  return { name,
    [prepare = std::move(prepare), material = std::move(material)]
    {
      const auto scene = NewScene(SmallTorso());
      prepare(*scene);
      return SceneOf(scene, material(*scene));
    } };
}

std::vector<float> ImageOver(const std::vector<float>& front, const std::vector<float>& back)
{
  std::vector<float> sum(front.size());
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    sum[i] = front[i] + (1.0f - front[i | 3]) * back[i];
  }
  return sum;
}
