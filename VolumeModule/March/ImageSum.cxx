#include "March/ImageSum.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <glm/common.hpp>

#include <chrono>

namespace varimarch
{

void ImageSum::Begin(const Fingerprint& newScene)
{
  if (this->scene != newScene)
  {
    this->scene = newScene;
    this->count = 0;
    this->strips.Restart();
  }
}

// The R2 sequence of M. Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018),
// based on the plastic number: any number of successive offsets is spread evenly.
glm::dvec2 ImageSum::NextOffsetPixels() const
{
  const glm::dvec2 step(0.7548776662466927, 0.5698402909980532);
  return glm::fract(0.5 + double(this->count) * step) - 0.5;
}

void ImageSum::Begin(
  vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw)
{
  this->sum.Draw(window, pixels, draw);
}

void ImageSum::Add(vtkOpenGLRenderWindow* window, const Viewport& pixels, double longestSeconds,
  const std::function<void()>& draw)
{
  this->imageRows = pixels.height;
  const PictureStrips::Rows strip = this->strips.Next(pixels.height, longestSeconds);
  if (longestSeconds > 0.0)
  {
    window->WaitForCompletion();
  }
  const auto begin = std::chrono::steady_clock::now();
  this->sum.DrawMore(window, pixels,
    [&]
    {
      vtkOpenGLState* const state = window->GetState();
      const vtkOpenGLState::ScopedglScissor scissor(state);
      state->vtkglEnable(GL_SCISSOR_TEST);
      state->vtkglScissor(0, strip.begin, pixels.width, strip.count);
      if (this->count == 0)
      {
        const vtkOpenGLState::ScopedglClearColor clearColor(state);
        state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        state->vtkglClear(GL_COLOR_BUFFER_BIT);
      }
      draw();
    });
  if (longestSeconds > 0.0)
  {
    window->WaitForCompletion();
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  this->strips.Took(strip, took.count(), longestSeconds);
  if (this->RowsOfNext() == pixels.height)
  {
    ++this->count;
    this->strips.Restart();
  }
}

void ImageSum::Release(vtkWindow* window)
{
  this->sum.Release(window);
  this->count = 0;
  this->strips.Restart();
}

}
