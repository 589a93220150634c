#include "Viewer/Open/WarningBar.h"

#include "Scene/SceneVolumes.h"
#include "Viewer/Model/Study.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include <algorithm>

namespace varimarch
{

QString ScanWarning::Text() const
{
  return this->name.isEmpty() ? this->sentence : this->name + ": " + this->sentence;
}

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

std::vector<ScanWarning> WarningBar::WarningsOf(const Scene& scene, const Study& study)
{
  std::vector<ScanWarning> all;
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    const Study& one = StudyOfVolume(study, volume);
    const std::string name = volume == 0 ? std::string() : scene.overlays[volume - 1].name;
    std::vector<std::string> sentences = one.volume.warnings;
    if (one.labels)
    {
      sentences.insert(sentences.end(), one.labels->warnings.begin(), one.labels->warnings.end());
    }
    for (const std::string& sentence : sentences)
    {
      all.push_back(
        { one.labelGuard, QString::fromStdString(sentence), QString::fromStdString(name) });
    }
  }
  return all;
}

void WarningBar::Show(const std::vector<ScanWarning>& warnings, const QString& remedy)
{
  this->SetWarnings(warnings, remedy);
  this->setVisible(!warnings.empty());
}

void WarningBar::Update(const std::vector<ScanWarning>& warnings, const QString& remedy)
{
  const auto isShown = [this](const ScanWarning& warning)
  {
    return std::any_of(this->shown.begin(), this->shown.end(),
      [&](const ScanWarning& other) { return warning.IsThatOf(other); });
  };
  const bool isAnyNew = !std::all_of(warnings.begin(), warnings.end(), isShown);
  this->SetWarnings(warnings, remedy);
  this->setVisible(isAnyNew || (!this->isHidden() && !warnings.empty()));
}

void WarningBar::SetWarnings(const std::vector<ScanWarning>& warnings, const QString& newRemedy)
{
  this->shown = warnings;
  this->remedy->setText(newRemedy);
  this->remedy->setVisible(!newRemedy.isEmpty());
  this->text->setText(this->Texts().join('\n'));
}

QStringList WarningBar::Texts() const
{
  QStringList texts;
  for (const ScanWarning& warning : this->shown)
  {
    texts.append(warning.Text());
  }
  return texts;
}

}
