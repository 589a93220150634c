#include "SoakBench.h"

#include "Machine.h"
#include "Scene/Median.h"
#include "Scene/OffscreenView.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <filesystem>
#include <iterator>
#include <memory>
#include <string>

namespace varimarch
{

namespace
{

int OpenFiles()
{
  return int(std::distance(
    std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator()));
}

/// A scene in a window, and the changes that a working day makes to it.
class Day
{
public:
  Day(const Scene& scene, vtkImageData* image)
    : scene(scene)
    , image(vtkSmartPointer<vtkImageData>::New())
  {
    this->image->ShallowCopy(image);
    vtkDataArray* const values = image->GetPointData()->GetScalars();
    for (vtkSmartPointer<vtkDataArray>& moment : this->moments)
    {
      moment.TakeReference(values->NewInstance());
      moment->DeepCopy(values);
    }
    ShiftValues(this->moments[1]);
    this->view = std::make_unique<OffscreenView>(scene, this->image, MapperKind::Varimarch);
  }

  /// Renders a frame and returns its time [ms].
  double Frame(int number)
  {
    ScenePipeline& pipeline = this->view->Pipeline();
    pipeline.Renderer()->GetActiveCamera()->Azimuth(1.0);
    if (number % 10 == 0)
    {
      Look look = this->scene.look;
      look.opacityUnitDistanceMm *= number % 20 == 0 ? 1.0 : 1.25;
      pipeline.SetLook(look);
    }
    if (number % 50 == 0)
    {
      this->image->GetPointData()->SetScalars(this->moments[number / 50 % 2]);
      this->image->Modified();
    }
    if (number % 200 == 0)
    {
      SceneCuts cuts = this->scene.cuts;
      if (number % 400 == 0)
      {
        cuts.box = { 0.2, 0.9, 0.0, 0.8, 0.1, 1.0 };
      }
      pipeline.SetCuts(cuts);
    }
    return 1000.0 * this->view->Render();
  }

private:
  /// Moves all values by one voxel, as if the patient had breathed.
  static void ShiftValues(vtkDataArray* values)
  {
    const vtkIdType count = values->GetNumberOfTuples();
    for (vtkIdType voxel = 0; voxel + 1 < count; ++voxel)
    {
      values->SetTuple(voxel, voxel + 1, values);
    }
  }

  Scene scene;
  vtkSmartPointer<vtkImageData> image;
  vtkSmartPointer<vtkDataArray> moments[2];
  std::unique_ptr<OffscreenView> view;
};

}

std::vector<SoakPart> Soak(const Scene& scene, const LoadedVolume& volume, int frames,
  const std::function<void(const SoakPart&)>& onPart)
{
  Day day(scene, volume.image);
  std::vector<SoakPart> parts;
  std::vector<double> times;
  for (int frame = 1; frame <= frames; ++frame)
  {
    times.push_back(day.Frame(frame));
    if (frame == int(std::int64_t(frames) * (int(parts.size()) + 1) / SoakParts))
    {
      parts.push_back(
        { frame, Median(times), ResidentMegabytes(), OpenFiles(), int(StatusNumber("Threads")) });
      times.clear();
      onPart(parts.back());
    }
  }
  return parts;
}

}
