#include "Viewer/View/ComparisonView.h"

#include "Scene/DifferencePicture.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/View/VolumeView.h"

#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <QVBoxLayout>

#include <vtkImageData.h>

namespace varimarch
{

namespace
{

constexpr int StillMilliseconds = 400;

// A byte picture, whose row 0 is the lowest.
QImage ImageOf(vtkImageData* bytePicture)
{
  const int* const size = bytePicture->GetDimensions();
  return QImage(static_cast<const uchar*>(bytePicture->GetScalarPointer()), size[0], size[1],
    3 * size[0], QImage::Format_RGB888)
    .mirrored();
}

}

ComparisonView::ComparisonView(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , ours(new VolumeView(model, MapperKind::Varimarch, this))
  , result(new QWidget(this))
  , picture(new QLabel)
  , numbers(new QLabel)
{
  auto* const layout = new QVBoxLayout(this->result);
  layout->addWidget(new QLabel(tr("Difference")));
  layout->addWidget(this->picture, 1);
  layout->addWidget(this->numbers);
  this->picture->setAlignment(Qt::AlignCenter);
  this->picture->setMinimumSize(1, 1);
  this->numbers->setWordWrap(true);
  this->result->hide();
  this->stillness.setSingleShot(true);
  this->stillness.setInterval(StillMilliseconds);
  connect(&this->stillness, &QTimer::timeout, this, &ComparisonView::Compare);
  connect(this->ours, &VolumeView::Drawn, this,
    [this]
    {
      if (this->theirs)
      {
        this->stillness.start();
      }
    });
}

void ComparisonView::CompareWith(std::optional<MapperKind> kind)
{
  delete this->theirs;
  this->theirs = nullptr;
  this->lastDifference.reset();
  this->stillness.stop();
  if (kind)
  {
    this->theirs = new VolumeView(this->model, *kind, this);
    this->theirs->SetTool(this->tool);
    connect(this->theirs, &VolumeView::Drawn, this, [this] { this->stillness.start(); });
    this->theirs->show();
  }
  this->result->setVisible(this->theirs != nullptr);
  this->PlaceParts();
}

void ComparisonView::SetTool(LeftButton button)
{
  this->tool = button;
  this->ours->SetTool(button);
  if (this->theirs)
  {
    this->theirs->SetTool(button);
  }
}

void ComparisonView::resizeEvent(QResizeEvent*)
{
  this->PlaceParts();
}

// Both pictures have the same number of pixels, so that they can be compared.
void ComparisonView::PlaceParts()
{
  const int count = this->theirs ? 3 : 1;
  const int width = this->width() / count;
  this->ours->setGeometry(0, 0, width, this->height());
  if (this->theirs)
  {
    this->theirs->setGeometry(width, 0, width, this->height());
    this->result->setGeometry(2 * width, 0, this->width() - 2 * width, this->height());
  }
}

void ComparisonView::Compare()
{
  if (!this->theirs || !this->ours->Pipeline() || !this->theirs->Pipeline())
  {
    return;
  }
  const vtkSmartPointer<vtkImageData> ourPicture = this->ours->FloatPicture();
  const vtkSmartPointer<vtkImageData> theirPicture = this->theirs->FloatPicture();
  this->lastDifference = CompareImages(static_cast<const float*>(theirPicture->GetScalarPointer()),
    static_cast<const float*>(ourPicture->GetScalarPointer()),
    std::size_t(ourPicture->GetNumberOfPoints()));
  this->ShowDifference(ourPicture, theirPicture);
  emit this->Compared();
}

void ComparisonView::ShowDifference(vtkImageData* ourPicture, vtkImageData* theirPicture)
{
  const QImage image = ImageOf(WithDifferenceScale(DifferencePicture(theirPicture, ourPicture)));
  this->picture->setPixmap(QPixmap::fromImage(
    image.scaled(this->picture->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation)));
  this->numbers->setText(tr("RMSE %1, largest %2 of 255. Ours %3 ms, VTK's %4 ms.")
                           .arg(this->lastDifference->rootMeanSquare, 0, 'f', 2)
                           .arg(this->lastDifference->largest, 0, 'f', 1)
                           .arg(1e3 * this->ours->PictureSeconds(), 0, 'f', 0)
                           .arg(1e3 * this->theirs->PictureSeconds(), 0, 'f', 0));
}

}
