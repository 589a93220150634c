#include "Viewer/Open/RawForm.h"

#include "Scene/Json/SceneNames.h"
#include "Scene/Volumes/RawGuess.h"
#include "Scene/Volumes/VolumeLoading.h"
#include "Viewer/Open/GrayImage.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <limits>

namespace varimarch
{

namespace
{

constexpr int MostVoxelsPerSide = 1 << 16;
constexpr int SmallestPreview = 256; ///< [logical pixels]
constexpr double LargestSpacingMm = 1000.0;

template <class SpinBox>
QHBoxLayout* RowOf(const std::array<SpinBox*, 3>& boxes)
{
  auto* const row = new QHBoxLayout;
  for (SpinBox* box : boxes)
  {
    row->addWidget(box);
  }
  return row;
}

// A slice as a volume of its own, with the slices before it as part of the header.
RawLayout LayoutOfSlice(RawLayout layout, int slice)
{
  layout.dimensions[2] = 1;
  const std::int64_t sliceBytes = BytesOf(layout) - layout.headerBytes;
  layout.headerBytes += slice * sliceBytes;
  return layout;
}

// Null if the slice cannot be read. Runs in the thread.
QImage PictureOfSlice(const FileSource& slice, const TaskProgress& progress)
{
  try
  {
    return ImageOf(MiddleSlice(LoadVolume(slice, progress).image));
  }
  catch (const std::exception&)
  {
    return {};
  }
}

}

RawForm::RawForm(const QString& file, QWidget* parent)
  : QDialog(parent)
  , path(file.toStdString())
  , fileBytes(QFileInfo(file).size())
  , isCompressed(file.endsWith(".gz", Qt::CaseInsensitive))
{
  this->setWindowTitle(tr("Layout of %1").arg(QFileInfo(file).fileName()));
  auto* const row = new QHBoxLayout;
  row->addLayout(this->MakeForm());
  row->addLayout(this->MakePreview(), 1);
  auto* const column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(this->MakeButtons());
  this->openButton->setDefault(true); // only works once it is in the dialog
  this->SetLayout(GuessedRawLayout(this->path, this->fileBytes));
}

QFormLayout* RawForm::MakeForm()
{
  auto* const form = new QFormLayout;
  const auto changed = [this] { this->Update(); };
  const QString axes[] = { tr("Columns"), tr("Rows"), tr("Slices") };
  for (int axis = 0; axis < 3; ++axis)
  {
    this->dimensions[axis] = new QSpinBox;
    this->dimensions[axis]->setRange(1, MostVoxelsPerSide);
    this->dimensions[axis]->setAccessibleName(axes[axis]);
    connect(this->dimensions[axis], QOverload<int>::of(&QSpinBox::valueChanged), this, changed);
    form->addRow(axes[axis], this->dimensions[axis]);
  }
  this->type = new QComboBox;
  for (const std::string& name : NamesOf(RawTypeNames()))
  {
    this->type->addItem(QString::fromStdString(name));
  }
  this->byteOrder = new QComboBox;
  this->byteOrder->addItems({ tr("little-endian"), tr("big-endian") });
  this->headerBytes = new QSpinBox;
  this->headerBytes->setRange(0, std::numeric_limits<int>::max());
  this->headerBytes->setAccessibleName(tr("Bytes before the first voxel"));
  connect(this->type, QOverload<int>::of(&QComboBox::currentIndexChanged), this, changed);
  connect(this->byteOrder, QOverload<int>::of(&QComboBox::currentIndexChanged), this, changed);
  connect(this->headerBytes, QOverload<int>::of(&QSpinBox::valueChanged), this, changed);
  form->addRow(tr("Type"), this->type);
  form->addRow(tr("Byte order"), this->byteOrder);
  form->addRow(tr("Header bytes"), this->headerBytes);
  const QString distances[] = { tr("Distance of columns [mm]"), tr("Distance of rows [mm]"),
    tr("Distance of slices [mm]") };
  for (int axis = 0; axis < 3; ++axis)
  {
    QDoubleSpinBox*& box = this->spacing[axis];
    box = new QDoubleSpinBox;
    box->setAccessibleName(distances[axis]);
    box->setDecimals(4);
    box->setRange(1e-4, LargestSpacingMm);
  }
  form->addRow(tr("Spacing [mm]"), RowOf(this->spacing));
  return form;
}

QLayout* RawForm::MakePreview()
{
  this->slicePicture = new QLabel;
  this->slicePicture->setObjectName("slicePicture");
  this->slicePicture->setMinimumSize(SmallestPreview, SmallestPreview);
  this->slicePicture->setAlignment(Qt::AlignCenter);
  this->slicePicture->setStyleSheet("background: black; color: #cccccc;");
  this->slice = new QSlider(Qt::Horizontal);
  this->slice->setAccessibleName(tr("Slice"));
  connect(this->slice, &QSlider::valueChanged, this, &RawForm::ReadSlice);
  this->fit = new QLabel;
  this->fit->setObjectName("fit");
  this->fit->setWordWrap(true);
  this->takeHeader = new QPushButton(tr("Skip them as a header"));
  this->takeHeader->setObjectName("takeHeader");
  this->takeHeader->setAutoDefault(false);
  connect(this->takeHeader, &QPushButton::clicked, this,
    [this]
    {
      const std::int64_t more = this->fileBytes - BytesOf(this->Layout());
      const std::int64_t header = this->headerBytes->value() + more;
      this->headerBytes->setValue(
        int(std::min<std::int64_t>(header, this->headerBytes->maximum())));
    });
  auto* const column = new QVBoxLayout;
  column->addWidget(this->slicePicture, 1);
  column->addWidget(this->slice);
  column->addWidget(this->fit);
  column->addWidget(this->takeHeader, 0, Qt::AlignLeft);
  return column;
}

QWidget* RawForm::MakeButtons()
{
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  this->openButton = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
  this->openButton->setObjectName("open");
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this,
    [this]
    {
      emit this->Chosen({ this->path, this->Layout() });
      this->accept();
    });
  return buttons;
}

RawLayout RawForm::Layout() const
{
  RawLayout layout;
  for (int axis = 0; axis < 3; ++axis)
  {
    layout.dimensions[axis] = this->dimensions[axis]->value();
    layout.spacingMm[axis] = this->spacing[axis]->value();
  }
  layout.type = this->type->currentText().toStdString();
  layout.bigEndian = this->byteOrder->currentIndex() == 1;
  layout.headerBytes = this->headerBytes->value();
  return layout;
}

void RawForm::SetLayout(const RawLayout& layout)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->dimensions[axis]->setValue(layout.dimensions[axis]);
    this->spacing[axis]->setValue(layout.spacingMm[axis]);
  }
  this->type->setCurrentText(QString::fromStdString(layout.type));
  this->slice->setMaximum(layout.dimensions[2] - 1);
  this->slice->setValue(layout.dimensions[2] / 2);
  this->Update();
}

void RawForm::Update()
{
  this->slice->setMaximum(this->dimensions[2]->value() - 1);
  this->ShowFit();
  this->ReadSlice();
}

void RawForm::ReadSlice()
{
  const FileSource source = { this->path, LayoutOfSlice(this->Layout(), this->slice->value()) };
  this->reading.StartAfterLast([source](const TaskProgress& progress)
    { return PictureOfSlice(source, progress); },
    [this](const QImage& read)
    {
      this->picture = read;
      this->ShowPicture();
    });
}

void RawForm::ShowFit()
{
  const std::int64_t more = this->fileBytes - BytesOf(this->Layout());
  const QLocale locale;
  this->openButton->setEnabled(this->isCompressed || more >= 0);
  this->takeHeader->setVisible(!this->isCompressed && more > 0);
  if (this->isCompressed)
  {
    this->fit->setText(
      tr("The file is compressed, so its size can only be checked when it is read."));
  }
  else if (more == 0)
  {
    this->fit->setText(tr("The layout fits: the file has the %1 bytes that it needs.")
                         .arg(locale.toString(qlonglong(this->fileBytes))));
  }
  else if (more > 0)
  {
    this->fit->setText(tr("The file has %1 bytes more than this layout needs.")
                         .arg(locale.toString(qlonglong(more))));
  }
  else
  {
    this->fit->setText(tr("The layout does not fit: the file has %1 bytes less than it needs.")
                         .arg(locale.toString(qlonglong(-more))));
  }
}

void RawForm::ShowPicture()
{
  if (this->picture.isNull())
  {
    this->slicePicture->setText(tr("The file ends before this slice"));
    return;
  }
  this->slicePicture->setPixmap(QPixmap::fromImage(this->picture.scaled(
    this->slicePicture->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation)));
}

void RawForm::resizeEvent(QResizeEvent* event)
{
  QDialog::resizeEvent(event);
  this->ShowPicture();
}

}
