// Windows without a display show one volume together, and explain why they cannot draw.

#include "Module/Scenes/HomogeneousScene.h"
#include "Support/ExpectedVtkErrors.h"
#include "Support/ResettingDriver.h"
#include "VtkVersions.h"

#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <thread>

namespace
{

// Red, green and blue of the middle pixel of a window.
std::array<int, 3> Middle(vtkRenderWindow* window)
{
  window->Render();
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, false, pixels);
  const auto* middle = pixels->GetPointer(3 * (size[1] / 2 * size[0] + size[0] / 2));
  return { middle[0], middle[1], middle[2] };
}

void ExpectPiece(const std::array<int, 3>& drawn, const HomogeneousScene& scene)
{
  const std::array<double, 4> piece = scene.Piece(HomogeneousScene::SideMm);
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_NEAR(drawn[channel], 255.0 * piece[channel], 1.0) << channel;
  }
}

struct OtherWindow
{
  explicit OtherWindow(HomogeneousScene& scene, int size = 24)
  {
    this->window->SetSize(size, size);
    this->window->AddRenderer(this->renderer);
    this->renderer->AddVolume(scene.volume);
    this->renderer->SetActiveCamera(scene.renderer->GetActiveCamera());
  }

  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
};

}

TEST(HeadlessWindow, TwoMayShowOneVolumeInTurn)
{
  for (const bool processor : { false, true })
  {
    HomogeneousScene scene(0.05);
    scene.mapper->SetProcessorMarching(processor);
    OtherWindow other(scene);
    for (int turn = 0; turn < 3; ++turn)
    {
      SCOPED_TRACE(turn);
      ExpectPiece(Middle(scene.window), scene);
      ExpectPiece(Middle(other.window), scene);
    }
  }
}

TEST(HeadlessWindow, ReturnsToTheContextThatWasCurrent)
{
  vtkNew<vtkHeadlessRenderWindow> first;
  vtkNew<vtkHeadlessRenderWindow> second;
  first->Initialize();
  second->Initialize();
  first->MakeCurrent();
  second->PushContext();
  EXPECT_TRUE(second->IsCurrent() && !first->IsCurrent());
  second->PushContext();
  second->PopContext();
  EXPECT_TRUE(second->IsCurrent());
  second->PopContext();
  EXPECT_TRUE(first->IsCurrent() && !second->IsCurrent());
}

TEST(HeadlessWindow, HasADepthThatVtkMayAskFor)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  window->Initialize();
  window->MakeCurrent();
  ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  EXPECT_GE(window->GetDepthBufferSize(), 24);
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(HeadlessWindow, TellsOnceThatItsGraphicsCardWasReset)
{
  HomogeneousScene scene(0.05);
  scene.window->Render();
  if (!ResettingDriver::CanTell())
  {
    GTEST_SKIP() << "the driver cannot tell";
  }
  const ExpectedVtkErrors errors;
  const ResettingDriver driver(2);
  scene.window->Render();
  scene.window->Render();
  ASSERT_EQ(errors.Messages().size(), 1u) << errors.Text();
  EXPECT_NE(errors.Text().find("The graphics card was reset"), std::string::npos) << errors.Text();
}

TEST(HeadlessWindow, DrawsAVolumeWithMultisamplesAndPeeling)
{
  for (const int samples : { 0, 4 })
  {
    SCOPED_TRACE(samples);
    HomogeneousScene scene(0.05);
    scene.window->SetMultiSamples(samples);
    UseDepthPeeling(scene.renderer);
    const ExpectedVtkErrors warnings;
    ExpectPiece(Middle(scene.window), scene);
    ExpectPiece(Middle(scene.window), scene);
    EXPECT_EQ(warnings.Messages().size(), samples > 0 ? 1u : 0u) << warnings.Text();
  }
}

TEST(HeadlessWindow, SaysOnceThatAnotherThreadHasItsContext)
{
  HomogeneousScene scene(0.05);
  scene.window->Render(); // the context stays current here
  const ExpectedVtkErrors errors;
  std::thread(
    [&]
    {
      scene.window->Render();
      scene.window->Render();
    })
    .join();
  ASSERT_EQ(errors.Messages().size(), 1u) << errors.Text();
  EXPECT_NE(errors.Text().find("in one thread only"), std::string::npos) << errors.Text();
}

TEST(HeadlessWindow, IsRefusedInACopyOfAProcessThatHasDrawn)
{
  HomogeneousScene(0.05).window->Render();
  const pid_t child = fork();
  if (child == 0)
  {
    // A new window would wait forever for threads that were not copied.
    alarm(10);
    vtkNew<vtkHeadlessRenderWindow> window;
    const bool isRefused = !window->InitializeContext() &&
      window->GetFailureReason().find("forked") != std::string::npos;
    _exit(isRefused ? 0 : 1);
  }
  int status = 1;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}
