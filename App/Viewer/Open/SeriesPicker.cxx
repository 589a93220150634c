#include "Viewer/Open/SeriesPicker.h"

#include "Viewer/Open/GrayImage.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace varimarch
{

namespace
{

constexpr QSize SlicePictureSize(112, 112);

// Descriptions are typed by operators and may be empty or long.
QString TextOf(const SeriesSummary& summary)
{
  const QString description = QString::fromStdString(summary.description).trimmed();
  return SeriesPicker::tr("%1\n%2, images: %3")
    .arg(description.isEmpty() ? SeriesPicker::tr("No description") : description.left(60),
      QString::fromStdString(summary.modality))
    .arg(summary.imageCount);
}

}

SeriesPicker::SeriesPicker(std::vector<SeriesSummary> allSeries, QWidget* parent)
  : QDialog(parent)
  , series(std::move(allSeries))
  , list(new QListWidget)
{
  this->setWindowTitle(tr("Choose a series"));
  this->resize(520, 460);
  this->list->setIconSize(SlicePictureSize);
  this->list->setSpacing(4);
  this->list->setAccessibleName(tr("Series"));
  for (const SeriesSummary& summary : this->series)
  {
    this->Add(summary);
  }
  this->list->setCurrentRow(0);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  QPushButton* const open = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
  auto* const column = new QVBoxLayout(this);
  column->addWidget(new QLabel(tr("Found %1 series.").arg(this->series.size())));
  column->addWidget(this->list, 1);
  column->addWidget(buttons);
  open->setDefault(true); // only works once it is in the dialog
  connect(buttons, &QDialogButtonBox::accepted, this, &SeriesPicker::Choose);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  // Emitted for Return and for a double-click.
  connect(this->list, &QListWidget::itemActivated, this, &SeriesPicker::Choose);
}

void SeriesPicker::Add(const SeriesSummary& summary)
{
  QPixmap picture(SlicePictureSize);
  picture.fill(Qt::black);
  if (!summary.middle.pixels.empty())
  {
    picture = QPixmap::fromImage(
      ImageOf(summary.middle)
        .scaled(SlicePictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  }
  new QListWidgetItem(picture, TextOf(summary), this->list);
}

void SeriesPicker::Choose()
{
  if (!this->isVisible())
  {
    return; // Return triggers both the list and the button
  }
  emit this->Chosen(QString::fromStdString(this->series[this->list->currentRow()].uid));
  this->accept();
}

}
