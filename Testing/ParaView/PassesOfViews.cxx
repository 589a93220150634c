// Looks for ParaView's pass that composites pictures of processes, and for the camera's pass of one
// process, below passes that process the image, as tone mapping and blur do. Prints what it does
// not find; the exit code is then 1.

#include "OrderOfProcesses.h"

#include <vtkCameraPass.h>
#include <vtkGaussianBlurPass.h>
#include <vtkIceTCompositePass.h>
#include <vtkNew.h>
#include <vtkPVDefaultPass.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkToneMappingPass.h>

#include <iostream>

namespace
{

int failures = 0;

void Expect(vtkIceTCompositePass* expected, vtkRenderPass* pass, const char* passes)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetPass(pass);
  if (varimarch::CompositePassOf(renderer) != expected)
  {
    ++failures;
    std::cout << "Not found: the compositing pass of a view with " << passes << "\n";
  }
}

void ExpectCamera(vtkCameraPass* expected, vtkRenderPass* pass, const char* passes)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetPass(pass);
  if (varimarch::UsualCameraPassOf(renderer) != expected)
  {
    ++failures;
    std::cout << "Not found: the camera's pass of a view with " << passes << "\n";
  }
}

}

int main()
{
  vtkNew<vtkIceTCompositePass> composite;
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(composite);
  vtkNew<vtkToneMappingPass> tones;
  tones->SetDelegatePass(camera);
  vtkNew<vtkGaussianBlurPass> blur;
  blur->SetDelegatePass(tones);
  Expect(composite, composite, "no other pass");
  Expect(composite, camera, "a camera");
  Expect(composite, tones, "tone mapping");
  Expect(composite, blur, "tone mapping behind a blur");
  ExpectCamera(nullptr, blur, "compositing");
  vtkNew<vtkPVDefaultPass> usual;
  camera->SetDelegatePass(usual);
  ExpectCamera(camera, camera, "a camera");
  ExpectCamera(camera, blur, "tone mapping behind a blur");
  ExpectCamera(nullptr, usual, "no camera");
  vtkNew<vtkSequencePass> drawing;
  camera->SetDelegatePass(drawing);
  Expect(nullptr, blur, "no compositing");
  Expect(nullptr, nullptr, "no pass");
  ExpectCamera(nullptr, blur, "drawing of another kind");
  return failures > 0 ? 1 : 0;
}
