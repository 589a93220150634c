#include "AccumulatedPictures.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/common.hpp>

namespace varimarch
{

void AccumulatedPictures::Begin(const std::vector<double>& newScene)
{
  if (this->scene != newScene)
  {
    this->scene = newScene;
    this->count = 0;
  }
}

// Any number of these in a row is spread evenly: M. Roberts, "The unreasonable effectiveness of
// quasirandom sequences" (2018), with the plastic number.
glm::dvec2 AccumulatedPictures::NextOffsetPixels() const
{
  const glm::dvec2 step(0.7548776662466927, 0.5698402909980532);
  return glm::fract(0.5 + double(this->count) * step) - 0.5;
}

void AccumulatedPictures::Add(
  vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw)
{
  this->count == 0 ? this->sum.Draw(window, pixels, draw)
                   : this->sum.DrawMore(window, pixels, draw);
  ++this->count;
}

void AccumulatedPictures::Release(vtkWindow* window)
{
  this->sum.Release(window);
  this->count = 0;
}

}
