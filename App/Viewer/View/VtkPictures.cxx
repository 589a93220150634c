#include "Viewer/View/VtkPictures.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <EGL/egl.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace varimarch
{

QImage ImageOfBytes(vtkImageData* picture)
{
  const int* const size = picture->GetDimensions();
  return QImage(static_cast<const uchar*>(picture->GetScalarPointer()), size[0], size[1],
    3 * size[0], QImage::Format_RGB888)
    .mirrored();
}

QImage ImageOfFloats(vtkImageData* picture)
{
  const int* const size = picture->GetDimensions();
  QImage image(size[0], size[1], QImage::Format_ARGB32_Premultiplied);
  const auto* rgba = static_cast<const float*>(picture->GetScalarPointer());
  const auto byteOf = [](float channel)
  { return int(std::lround(255.0F * std::clamp(channel, 0.0F, 1.0F))); };
  for (int row = size[1] - 1; row >= 0; --row)
  {
    auto* const pixels = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < size[0]; ++column, rgba += 4)
    {
      pixels[column] = qRgba(byteOf(rgba[0]), byteOf(rgba[1]), byteOf(rgba[2]), byteOf(rgba[3]));
    }
  }
  return image;
}

vtkSmartPointer<vtkImageData> BytesOfImage(const QImage& image)
{
  const QImage bytes = image.convertToFormat(
    image.hasAlphaChannel() ? QImage::Format_RGBA8888 : QImage::Format_RGB888);
  const int componentCount = bytes.depth() / 8;
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(bytes.width(), bytes.height(), 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, componentCount);
  for (int row = 0; row < bytes.height(); ++row)
  {
    std::memcpy(picture->GetScalarPointer(0, bytes.height() - 1 - row, 0), bytes.constScanLine(row),
      std::size_t(componentCount) * bytes.width());
  }
  return picture;
}

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

DrawingWithoutDisplay::DrawingWithoutDisplay()
{
  if (QOpenGLContext* const current = QOpenGLContext::currentContext())
  {
    current->doneCurrent();
  }
}

DrawingWithoutDisplay::~DrawingWithoutDisplay()
{
  if (eglGetCurrentContext() != EGL_NO_CONTEXT)
  {
    eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}

namespace
{

QString Problem(const QString& found)
{
  return QCoreApplication::translate("OpenGLProblem",
    "OpenGL 3.2 or later is needed, found %1; install or update the driver of the graphics card, "
    "or the package libgl1-mesa-dri, which draws without one")
    .arg(found);
}

/// A context without a window, which is current as long as it lives.
class HiddenContext
{
public:
  HiddenContext()
  {
    this->surface.create();
    this->isCurrent = this->context.create() && this->context.makeCurrent(&this->surface);
  }

  /// Null if there is no OpenGL.
  QOpenGLContext* Get() { return this->isCurrent ? &this->context : nullptr; }

private:
  QOffscreenSurface surface;
  QOpenGLContext context;
  bool isCurrent;
};

// True if VTK finds its functions in the current context. Debian's VTK looks for them by GLX only,
// whereas Qt may have made the context by EGL.
bool VtkCanUseContext()
{
  bool works = true;
  vtkNew<vtkCallbackCommand> failed;
  failed->SetClientData(&works);
  failed->SetCallback(
    [](vtkObject*, unsigned long, void* works, void*) { *static_cast<bool*>(works) = false; });
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->AddObserver(vtkCommand::ErrorEvent, failed);
  window->OpenGLInitContext();
  return works;
}

}

QString OpenGLProblem()
{
  HiddenContext hidden;
  if (!hidden.Get())
  {
    return Problem(QCoreApplication::translate("OpenGLProblem", "none"));
  }
  const auto [major, minor] = hidden.Get()->format().version();
  if (qMakePair(major, minor) < qMakePair(3, 2))
  {
    return Problem(QStringLiteral("%1.%2").arg(major).arg(minor));
  }
  return VtkCanUseContext()
    ? QString()
    : Problem(QCoreApplication::translate("OpenGLProblem", "a display without GLX"));
}

bool IsOpenGLOnProcessor()
{
  HiddenContext hidden;
  if (!hidden.Get())
  {
    return false;
  }
  const auto* const device =
    reinterpret_cast<const char*>(hidden.Get()->functions()->glGetString(GL_RENDERER));
  return QString::fromLatin1(device).contains("llvmpipe");
}

}
