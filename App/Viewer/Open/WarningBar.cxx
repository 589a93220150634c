#include "Viewer/Open/WarningBar.h"

#include "Scene/SceneVolumes.h"
#include "Viewer/Model/Study.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

namespace varimarch
{

WarningBar::WarningBar(QWidget* parent)
  : QFrame(parent)
  , text(new QLabel)
  , remedy(new QPushButton)
{
  this->setObjectName("warnings");
  // Fixed colours that are legible with dark and light themes.
  this->setStyleSheet("#warnings { background: #fff3cd; border-bottom: 1px solid #d9a400; }"
                      "#warnings QLabel { color: #3d2f00; }");
  auto* const sign = new QLabel;
  sign->setPixmap(this->style()->standardIcon(QStyle::SP_MessageBoxWarning).pixmap(20, 20));
  this->text->setTextFormat(Qt::PlainText);
  this->text->setWordWrap(true);
  this->text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->remedy->setObjectName("remedy");
  connect(this->remedy, &QPushButton::clicked, this, &WarningBar::RemedyWanted);
  auto* const close = new QToolButton;
  close->setIcon(this->style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  close->setAutoRaise(true);
  close->setToolTip(tr("Dismiss"));
  close->setAccessibleName(close->toolTip());
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(sign, 0, Qt::AlignTop);
  row->addWidget(this->text, 1);
  row->addWidget(this->remedy, 0, Qt::AlignTop);
  row->addWidget(close, 0, Qt::AlignTop);
  this->hide();
}

QStringList WarningBar::TextsOf(const Scene& scene, const Study& study)
{
  QStringList texts;
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    const Study& one = StudyOfVolume(study, volume);
    const std::string name = volume == 0 ? std::string() : scene.overlays[volume - 1].name;
    const QString begin = name.empty() ? QString() : QString::fromStdString(name) + ": ";
    std::vector<std::string> warnings = one.volume.warnings;
    if (one.labels)
    {
      warnings.insert(warnings.end(), one.labels->warnings.begin(), one.labels->warnings.end());
    }
    for (const std::string& warning : warnings)
    {
      texts.append(begin + QString::fromStdString(warning));
    }
  }
  return texts;
}

void WarningBar::Show(const QStringList& warnings, const QString& remedy)
{
  this->texts = warnings;
  this->remedy->setText(remedy);
  this->remedy->setVisible(!remedy.isEmpty());
  this->text->setText(warnings.join('\n'));
  this->setVisible(!warnings.isEmpty());
}

}
