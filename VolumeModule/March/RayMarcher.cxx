#include "March/RayMarcher.h"

#include "Frame/OverlappingVolumes.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace varimarch
{

void RayMarcher::Draw(Frame frame)
{
  this->EnterWindow(frame.window);
  this->BeginAccumulation(frame);
  this->volume.UpdateVoxels(frame);
  this->UpdateVoxelsOfOthers(frame);
  frame.marcher = this->MarchesPackets(frame) ? Marcher::Processor : Marcher::Device;
  if (frame.marcher == Marcher::Device)
  {
    this->packets.Release(frame.window);
  }
  else if (IsMixture(frame))
  {
    frame.settings.integration = Integration::Midpoint;
    frame.chooseIntegration = false;
  }
  frame.sampleDistanceMm = std::max(frame.sampleDistanceMm, ShortestSampleDistanceMm(frame));
  this->UpdateDepth(frame);
  this->UpdateNoise(frame);
  this->volume.UpdateCuts(frame);
  this->UpdateOthers(frame);
  this->volume.Update(frame, this->BytesElsewhere());
  if (this->volume.Blocks().Partition().Count() == 1)
  {
    this->accumulation.Release(frame.window);
  }
  this->drawnBox = this->BoxOfAll(frame);
  this->KeepTolerance(frame);
  this->usedSampleDistanceMm = frame.sampleDistanceMm;
  this->volume.UpdatePreIntegratedTable(frame);
  this->DrawPicture(frame);
}

void RayMarcher::EnterWindow(vtkOpenGLRenderWindow* window)
{
  if (this->window && this->window != window)
  {
    this->Release(this->window);
  }
  this->window = window;
}

void RayMarcher::UpdateDepth(const Frame& frame)
{
  if (!frame.settings.sceneGeometry)
  {
    this->depth.Release(frame.window);
    return;
  }
  this->depth.Capture(frame.window, frame.viewport.left, frame.viewport.bottom,
    frame.viewport.width, frame.viewport.height);
}

void RayMarcher::UpdateNoise(const Frame& frame)
{
  if (!frame.settings.jitter)
  {
    this->picture.noise.Release(frame.window);
    return;
  }
  this->picture.noise.MakeTile();
  frame.marcher == Marcher::Processor ? this->picture.noise.ReleaseTexture(frame.window)
                                      : this->picture.noise.Upload(frame.window);
}

void RayMarcher::UpdateProgram(const Frame& frame)
{
  if (this->program.Use(frame.window, frame.settings, frame.userCode))
  {
    ++this->shaderBuilds;
  }
  if (Marches(frame.settings))
  {
    this->shaderParts = this->program.Parts();
  }
}

// Steps that keep a tolerance take the place of those that were asked for.
void RayMarcher::KeepTolerance(Frame& frame)
{
  if (!(frame.errorTolerance > 0.0))
  {
    this->tolerance.Forget();
    this->probe.Release(frame.window);
    return;
  }
  this->tolerance.Update(frame, this->volume, this->ToleranceInputsOf(frame),
    [this](const Frame& tried) { return this->DrawProbe(tried); });
  frame.settings.integration = this->tolerance.Choice()->integration;
  // Others than those who found the steps may draw by them: shaders, that count readings.
  frame.sampleDistanceMm =
    std::max(this->tolerance.SampleDistanceInViewMm(), ShortestSampleDistanceMm(frame));
}

ToleranceInputs RayMarcher::ToleranceInputsOf(const Frame& frame) const
{
  ToleranceInputs inputs;
  inputs.Add(frame, this->volume.Builds());
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    inputs.Add(frame.others[i], this->others[i]->Builds());
  }
  return inputs;
}

std::vector<float> RayMarcher::DrawProbe(const Frame& frame)
{
  this->volume.UpdatePreIntegratedTable(frame);
  if (frame.marcher == Marcher::Processor)
  {
    return this->MarchProbe(frame);
  }
  this->probe.Draw(frame.window, frame.viewport, [&] { this->DrawVolume(frame); });
  return this->probe.Read(frame.window, frame.viewport);
}

MemoryElsewhere RayMarcher::BytesElsewhere() const
{
  return { this->depth.Bytes() + this->picture.Bytes() + this->BytesOfOthers(),
    this->accumulation.Bytes() };
}

std::size_t RayMarcher::GraphicsMemoryBytes() const
{
  return this->volume.Bytes() + this->depth.Bytes() + this->probe.Bytes() +
    this->accumulation.Bytes() + this->picture.Bytes() + this->packets.Bytes() +
    this->BytesOfOthers();
}

void RayMarcher::Release(vtkWindow* window)
{
  this->ReleaseOthers(window, 0);
  this->volume.Release(window);
  this->accumulation.Release(window);
  this->picture.Release(window);
  this->depth.Release(window);
  this->packets.Release(window);
  this->boxGeometry.Release();
  this->program.Release();
  this->probe.Release(window);
  this->tolerance.Forget();
  this->window = nullptr;
}

}
