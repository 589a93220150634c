#include "Viewer/View/ComparisonView.h"

#include "Scene/Images/DifferencePicture.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/View/VolumeView.h"
#include "Viewer/View/VtkPictures.h"

#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QVBoxLayout>

#include <vtkImageData.h>

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr int ComparedMilliseconds = 400;
constexpr int GapPixels = 3;     // between images
constexpr int DividerPixels = 9; // area that can be grabbed, around a visible line
constexpr double DividerStep = 0.02;

}

// The divider between two images that lie over each other. The arrow keys move it too.
class ComparisonView::Divider : public QWidget
{
public:
  explicit Divider(ComparisonView* view)
    : QWidget(view)
    , view(view)
  {
    this->setCursor(Qt::SplitHCursor);
    this->setFocusPolicy(Qt::StrongFocus);
    this->setAccessibleName(ComparisonView::tr("Divider between our image and VTK's"));
    this->hide();
  }

protected:
  void mouseMoveEvent(QMouseEvent* event) override
  {
    this->view->MoveDivider(
      double(this->mapToParent(event->pos()).x()) / std::max(this->view->width(), 1));
  }

  void keyPressEvent(QKeyEvent* event) override
  {
    const int key = event->key();
    if (key != Qt::Key_Left && key != Qt::Key_Right)
    {
      QWidget::keyPressEvent(event);
      return;
    }
    this->view->MoveDivider(
      this->view->dividerPart + (key == Qt::Key_Left ? -DividerStep : DividerStep));
  }

  void paintEvent(QPaintEvent*) override
  {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle = QRectF(this->rect()).center();
    painter.setPen(QPen(QColor(0, 0, 0, 140), 3.0));
    painter.drawLine(QPointF(middle.x(), 0.0), QPointF(middle.x(), this->height()));
    painter.setPen(QPen(Qt::white, 1.0));
    painter.drawLine(QPointF(middle.x(), 0.0), QPointF(middle.x(), this->height()));
    painter.setBrush(this->hasFocus() ? QColor(120, 200, 255) : QColor(Qt::white));
    painter.drawRoundedRect(QRectF(middle - QPointF(3.5, 14.0), QSizeF(7.0, 28.0)), 3.0, 3.0);
  }

private:
  ComparisonView* view;
};

ComparisonView::ComparisonView(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , ours(new VolumeView(model, MapperKind::Varimarch, this))
  , theirPart(new QWidget(this))
  , divider(new Divider(this))
  , result(new QWidget(this))
  , title(new QLabel)
  , picture(new QLabel)
  , numbers(new QLabel)
{
  auto* const layout = new QHBoxLayout(this->result);
  layout->addWidget(this->picture, 1);
  auto* const texts = new QVBoxLayout;
  layout->addLayout(texts, 1);
  texts->addWidget(this->title);
  texts->addWidget(this->numbers);
  texts->addStretch();
  this->picture->setObjectName("difference");
  this->picture->setAlignment(Qt::AlignCenter);
  this->picture->setMinimumSize(1, 1);
  this->numbers->setWordWrap(true);
  this->result->hide();
  this->stillness.setSingleShot(true);
  this->stillness.setInterval(ComparedMilliseconds);
  connect(&this->stillness, &QTimer::timeout, this, &ComparisonView::Compare);
  connect(this->ours, &VolumeView::Drawn, this,
    [this]
    {
      if (this->theirs)
      {
        this->AwaitStillness();
      }
    });
}

// Until the next comparison, the difference is that of earlier images.
void ComparisonView::AwaitStillness()
{
  this->stillness.start();
  this->result->setEnabled(false);
  this->title->setText(tr("Difference (out of date)"));
}

void ComparisonView::CompareWith(std::optional<MapperKind> kind)
{
  delete this->theirs;
  this->theirs = nullptr;
  this->lastDifference.reset();
  this->stillness.stop();
  this->ours->SetRefining(!kind);
  if (kind)
  {
    this->theirKind = *kind;
    this->theirs = new VolumeView(this->model, *kind, this->theirPart);
    this->theirs->SetTool(this->tool);
    connect(this->theirs, &VolumeView::Drawn, this, [this] { this->AwaitStillness(); });
    this->theirs->show();
  }
  this->PlaceParts();
}

void ComparisonView::SetWipe(bool newWipe)
{
  this->wipe = newWipe;
  this->PlaceParts();
}

void ComparisonView::MoveDivider(double part)
{
  this->dividerPart = std::clamp(part, 0.0, 1.0);
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

// Both images always have the same size, so that they can be compared pixel by pixel.
void ComparisonView::PlaceParts()
{
  const bool compares = this->theirs != nullptr;
  this->theirPart->setVisible(compares);
  this->result->setVisible(compares);
  this->divider->setVisible(compares && this->wipe);
  this->title->setVisible(!this->wipe);
  this->picture->setVisible(!this->wipe);
  if (!compares)
  {
    this->ours->setGeometry(this->rect());
  }
  else if (this->wipe)
  {
    this->PlaceOverEachOther();
  }
  else
  {
    this->PlaceInGrid();
  }
}

// A quarter of the view has the shape of the whole view, so that the images show the same part.
void ComparisonView::PlaceInGrid()
{
  const QSize pane((this->width() - GapPixels) / 2, (this->height() - GapPixels) / 2);
  const QPoint second(pane.width() + GapPixels, pane.height() + GapPixels);
  this->ours->setGeometry(QRect(QPoint(0, 0), pane));
  this->theirPart->setGeometry(QRect(QPoint(second.x(), 0), pane));
  this->theirs->setGeometry(QRect(QPoint(0, 0), pane));
  this->theirs->SetReportSide(Qt::AlignLeft);
  this->result->setGeometry(0, second.y(), this->width(), this->height() - second.y());
}

// VTK's image lies over ours and is clipped at the divider.
void ComparisonView::PlaceOverEachOther()
{
  const int below = this->result->heightForWidth(this->width()) > 0
    ? this->result->heightForWidth(this->width())
    : this->result->sizeHint().height();
  const QSize size(this->width(), std::max(this->height() - below, 1));
  const int place = int(this->dividerPart * size.width());
  this->ours->setGeometry(QRect(QPoint(0, 0), size));
  this->theirPart->setGeometry(place, 0, size.width() - place, size.height());
  this->theirs->setGeometry(QRect(QPoint(-place, 0), size));
  this->theirs->SetReportSide(Qt::AlignRight);
  this->result->setGeometry(0, size.height(), size.width(), below);
  this->divider->setGeometry(place - DividerPixels / 2, 0, DividerPixels, size.height());
  this->divider->raise();
}

void ComparisonView::Compare()
{
  if (!this->theirs || !this->ours->Pipeline() || !this->theirs->Pipeline())
  {
    return;
  }
  const QStringList leftOut = LeftOutByVtk(this->theirKind, this->model->CurrentScene());
  if (!leftOut.isEmpty())
  {
    this->WithholdDifference(leftOut);
    return;
  }
  const WaitCursor cursor;
  const vtkSmartPointer<vtkImageData> theirPicture = this->theirs->FloatPicture();
  if (!theirPicture)
  {
    return; // the view says when it is complete
  }
  const vtkSmartPointer<vtkImageData> ourPicture = this->ours->FloatPicture();
  if (!ourPicture || ourPicture->GetNumberOfPoints() != theirPicture->GetNumberOfPoints())
  {
    return; // a picture of this scene and size follows
  }
  this->lastDifference = CompareImages(static_cast<const float*>(theirPicture->GetScalarPointer()),
    static_cast<const float*>(ourPicture->GetScalarPointer()),
    std::size_t(ourPicture->GetNumberOfPoints()));
  this->ShowDifference(ourPicture, theirPicture);
  this->result->setEnabled(true);
  this->title->setText(tr("Difference"));
  this->PlaceParts();
  emit this->Compared();
}

// Images of different scenes have no difference that tells anything about a mapper.
void ComparisonView::WithholdDifference(const QStringList& leftOut)
{
  this->lastDifference.reset();
  this->picture->setPixmap({});
  this->numbers->setText(
    tr("There is no difference, because VTK's mapper does not draw the whole scene: %1.")
      .arg(leftOut.join(", ")));
  this->result->setEnabled(true);
  this->title->setText(tr("No difference"));
  this->PlaceParts();
  emit this->Compared();
}

void ComparisonView::ShowDifference(vtkImageData* ourPicture, vtkImageData* theirPicture)
{
  this->numbers->setText(tr("RMSE %1, largest %2, in 1/255. Ours %3 ms, VTK's %4 ms.")
                           .arg(NumberText(this->lastDifference->rootMeanSquare, 2))
                           .arg(NumberText(this->lastDifference->largest, 1))
                           .arg(NumberText(1e3 * this->ours->PictureSeconds(), 0))
                           .arg(NumberText(1e3 * this->theirs->PictureSeconds(), 0)));
  // Lay out first: more lines of text leave less room for the image.
  this->result->layout()->activate();
  const QImage image =
    ImageOfBytes(WithDifferenceScale(DifferencePicture(theirPicture, ourPicture)));
  const double ratio = this->devicePixelRatioF();
  QPixmap pixmap = QPixmap::fromImage(
    image.scaled(this->picture->size() * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  pixmap.setDevicePixelRatio(ratio);
  this->picture->setPixmap(pixmap);
}

}
