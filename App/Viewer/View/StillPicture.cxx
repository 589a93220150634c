#include "Viewer/View/StillPicture.h"

#include "Viewer/View/VtkPictures.h"

#include <QElapsedTimer>
#include <QPainter>

#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr int FirstBandRows = 16;
constexpr double BandSeconds = 0.1;
constexpr double MostGrowth = 8.0; // rows may differ in cost
constexpr double AnyTimeSeconds = 1000.0;

}

void StillPicture::Clear()
{
  this->capture.reset();
  this->picture = nullptr;
  this->image = QImage();
}

void StillPicture::Begin(vtkOpenGLRenderWindow* window, vtkRenderer* renderer)
{
  this->Clear();
  this->capture.emplace(window, renderer);
  this->bandRows = FirstBandRows;
  this->seconds = 0.0;
  // The mapper is not to save time by fewer rays.
  renderer->SetAllocatedRenderTime(AnyTimeSeconds);
}

bool StillPicture::Continue()
{
  QElapsedTimer timer;
  timer.start();
  this->capture->RenderRows(this->bandRows);
  const double bandSeconds = 1e-9 * double(timer.nsecsElapsed());
  this->seconds += bandSeconds;
  const double growth = std::min(BandSeconds / std::max(bandSeconds, 1e-6), MostGrowth);
  this->bandRows = std::max(int(this->bandRows * growth), 1);
  if (this->capture->RowsLeft() > 0)
  {
    return false;
  }
  this->picture = this->capture->Image();
  this->image = ImageOfFloats(this->picture);
  this->capture.reset();
  return true;
}

void StillPicture::Paint(QPainter& painter, const QRect& rect, const QColor& background) const
{
  if (this->picture)
  {
    painter.fillRect(rect, background);
    painter.drawImage(rect, this->image);
  }
}

}
