#include "Viewer/Tools/ToolIcons.h"

#include <QByteArray>
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QString>
#include <QSvgRenderer>

#include <utility>

// Q_INIT_RESOURCE must be used outside of namespaces.
static void LoadIcons()
{
  Q_INIT_RESOURCE(icons);
}

namespace varimarch
{

namespace
{

/// Draws an SVG image, whose "currentColor" is the colour of the texts of buttons.
class SvgIcon : public QIconEngine
{
public:
  explicit SvgIcon(QByteArray svg)
    : svg(std::move(svg))
  {
  }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
  {
    const QColor color = QGuiApplication::palette().color(
      mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, QPalette::ButtonText);
    QByteArray colored = this->svg;
    colored.replace("currentColor", color.name().toLatin1());
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    QSvgRenderer(colored).render(painter, rect);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
  {
    QPixmap drawn(size);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    this->paint(&painter, drawn.rect(), mode, state);
    return drawn;
  }

  QIconEngine* clone() const override { return new SvgIcon(this->svg); }

private:
  QByteArray svg;
};

QIcon IconNamed(const QString& name)
{
  LoadIcons();
  QFile file(":/icons/" + name + ".svg");
  file.open(QIODevice::ReadOnly);
  return QIcon(new SvgIcon(file.readAll())); // which owns it
}

}

QIcon IconOf(LeftButton button)
{
  switch (button)
  {
    case LeftButton::Turn:
      return IconNamed("rotate");
    case LeftButton::Walk:
      return IconNamed("walk");
    case LeftButton::Brightness:
      return IconNamed("window-level");
    case LeftButton::Distance:
      return IconNamed("distance");
    case LeftButton::Angle:
      return IconNamed("angle");
    case LeftButton::Box:
      return IconNamed("box");
    case LeftButton::CutOut:
      return IconNamed("scissors");
    case LeftButton::KeepOnly:
      return IconNamed("keep-inside");
    default:
      return AnnotationIcon();
  }
}

QIcon AnnotationIcon()
{
  return IconNamed("annotate");
}

}
