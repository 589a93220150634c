#include "Viewer/Tour.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace varimarch
{

namespace
{

constexpr int FramePixels = 4;
constexpr int TextPixels = 340;

}

// Lies over the window and lets the mouse through.
class Tour::Frame : public QWidget
{
public:
  explicit Frame(QWidget* window)
    : QWidget(window)
  {
    this->setAttribute(Qt::WA_TransparentForMouseEvents);
    this->setObjectName("tourFrame");
  }

protected:
  // Two colours, one of which differs from anything below.
  void paintEvent(QPaintEvent*) override
  {
    QPainter painter(this);
    const QRectF inner = QRectF(this->rect()).adjusted(2.0, 2.0, -2.0, -2.0);
    painter.setPen(QPen(this->palette().color(QPalette::Window), FramePixels));
    painter.drawRect(inner);
    painter.setPen(QPen(this->palette().color(QPalette::Highlight), FramePixels, Qt::DashLine));
    painter.drawRect(inner);
  }
};

Tour::Tour(std::vector<TourStep> steps, QWidget* window)
  : QDialog(window)
  , steps(std::move(steps))
  , frame(new Frame(window))
  , title(new QLabel)
  , text(new QLabel)
  , back(new QPushButton(tr("Back")))
  , next(new QPushButton)
{
  this->setObjectName("tour");
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->title->setObjectName("tourTitle");
  this->text->setWordWrap(true);
  this->text->setFixedWidth(TextPixels);
  this->back->setObjectName("tourBack");
  this->next->setObjectName("tourNext");
  this->next->setDefault(true);
  auto* const end = new QPushButton(tr("End the tour"));
  end->setObjectName("tourEnd");
  auto* const buttons = new QHBoxLayout;
  buttons->addWidget(end);
  buttons->addStretch();
  buttons->addWidget(this->back);
  buttons->addWidget(this->next);
  auto* const column = new QVBoxLayout(this);
  column->addWidget(this->title);
  column->addWidget(this->text);
  column->addLayout(buttons);
  connect(end, &QPushButton::clicked, this, &QDialog::close);
  connect(this->back, &QPushButton::clicked, this, [this] { this->Show(this->current - 1); });
  connect(this->next, &QPushButton::clicked, this,
    [this]
    {
      if (this->current + 1 < int(this->steps.size()))
      {
        this->Show(this->current + 1);
      }
      else
      {
        this->close();
      }
    });
  window->installEventFilter(this);
  this->Show(0);
}

// The window may be what ends.
Tour::~Tour()
{
  delete this->frame;
}

void Tour::Show(int step)
{
  this->current = step;
  const TourStep& shown = this->steps[step];
  if (this->target)
  {
    this->target->removeEventFilter(this);
  }
  this->target = shown.target();
  this->target->installEventFilter(this);
  this->setWindowTitle(tr("Tour: %1 of %2").arg(step + 1).arg(this->steps.size()));
  this->title->setText("<b>" + shown.title.toHtmlEscaped() + "</b>");
  this->text->setText(shown.text);
  this->back->setEnabled(step > 0);
  this->next->setText(step + 1 < int(this->steps.size()) ? tr("Next") : tr("Done"));
  this->PlaceFrame();
}

void Tour::PlaceFrame()
{
  if (!this->target)
  {
    return; // the window ends
  }
  QWidget* const window = this->parentWidget();
  const QPoint corner = this->target->mapTo(window, QPoint(0, 0));
  this->frame->setGeometry(QRect(corner, this->target->size())
                             .adjusted(-FramePixels, -FramePixels, FramePixels, FramePixels)
                             .intersected(window->rect()));
  this->frame->setVisible(this->target->isVisible());
  this->frame->raise();
}

bool Tour::eventFilter(QObject* watched, QEvent* event)
{
  const QEvent::Type type = event->type();
  if (type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show ||
    type == QEvent::Hide || type == QEvent::LayoutRequest)
  {
    this->PlaceFrame();
  }
  return QDialog::eventFilter(watched, event);
}

}
