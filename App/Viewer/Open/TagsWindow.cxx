#include "Viewer/Open/TagsWindow.h"

#include "Readers/Dicom/TaggedSeries.h"
#include "Viewer/Studies/StudyTree.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QSpinBox>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

#include <algorithm>

namespace varimarch
{

namespace
{

// Columns of the tree.
enum TagColumn
{
  TagNumber,
  TagName,
  TagKind,
  TagValue
};

QStringList ColumnsOf(const DicomTag& tag)
{
  return { QString::fromStdString(tag.tag), QString::fromStdString(tag.name),
    QString::fromStdString(tag.representation), QString::fromStdString(tag.value) };
}

// Items for attributes, those of sequences below them.
QList<QTreeWidgetItem*> ItemsOf(const std::vector<DicomTag>& tags)
{
  QList<QTreeWidgetItem*> top;
  std::vector<QTreeWidgetItem*> path; // the last item of each depth
  for (const DicomTag& tag : tags)
  {
    auto* const item = new QTreeWidgetItem(ColumnsOf(tag));
    path.resize(std::min(path.size(), std::size_t(tag.depth)));
    path.empty() ? top.append(item) : path.back()->addChild(item);
    path.push_back(item);
  }
  return top;
}

}

TagsWindow::TagsWindow(const FileSource& source, QWidget* parent)
  : QDialog(parent)
  , search(new QLineEdit)
  , image(new QSpinBox)
  , status(new QLabel(tr("Reading the attributes…")))
  , tree(new QTreeWidget)
{
  this->setObjectName("tags");
  this->setWindowTitle(tr("DICOM attributes"));
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->resize(820, 620);
  this->search->setPlaceholderText(tr("Search in tags, names and values"));
  this->search->setAccessibleName(tr("Search"));
  this->search->setClearButtonEnabled(true);
  this->image->setAccessibleName(tr("Image"));
  this->image->setEnabled(false);
  this->image->setKeyboardTracking(false);
  this->status->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->tree->setAccessibleName(tr("Attributes"));
  this->tree->setHeaderLabels({ tr("Tag"), tr("Name"), tr("VR"), tr("Value") });
  this->tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
  this->tree->setUniformRowHeights(true);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* const copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
  copy->setObjectName("copy");
  copy->setToolTip(tr("Copies the selected attributes, or all that are shown (Ctrl+C)"));
  auto* const row = new QHBoxLayout;
  row->addWidget(this->search, 1);
  row->addWidget(new QLabel(tr("Image")));
  row->addWidget(this->image);
  auto* const column = new QVBoxLayout(this);
  column->addLayout(row);
  column->addWidget(this->tree, 1);
  column->addWidget(this->status);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(copy, &QPushButton::clicked, this, &TagsWindow::Copy);
  auto* const copyKey = new QShortcut(QKeySequence::Copy, this->tree);
  copyKey->setContext(Qt::WidgetShortcut);
  connect(copyKey, &QShortcut::activated, this, &TagsWindow::Copy);
  connect(this->search, &QLineEdit::textChanged, this->tree,
    [this](const QString& words) { ShowMatching(this->tree, words); });
  connect(this->image, QOverload<int>::of(&QSpinBox::valueChanged), this, &TagsWindow::ReadFile);
  connect(&this->task, &BackgroundTask::Failed, this->status, &QLabel::setText);
  this->status->setTextFormat(Qt::PlainText);
  this->status->setWordWrap(true);
  this->FindFiles(source);
}

void TagsWindow::FindFiles(const FileSource& source)
{
  this->task.Start(
    [source](const TaskProgress& goesOn)
    {
      ReadProgress progress(goesOn);
      return std::make_shared<const TaggedSeries>(source.path, source.series, progress);
    },
    [this](const std::shared_ptr<const TaggedSeries>& found) { this->ShowSeries(found); });
}

// The first attributes are those of the middle image, which usually shows most of the patient.
void TagsWindow::ShowSeries(const std::shared_ptr<const TaggedSeries>& found)
{
  this->series = found;
  const int count = int(found->Count());
  const QSignalBlocker quiet(this->image);
  this->image->setRange(1, count);
  this->image->setSuffix(tr(" of %1").arg(count));
  this->image->setValue(count / 2 + 1);
  this->image->setEnabled(count > 1);
  this->ReadFile();
}

void TagsWindow::ReadFile()
{
  const auto index = std::size_t(this->image->value() - 1);
  this->task.Start([files = this->series, index](const TaskProgress&)
    { return files->Tags(index); },
    [this, index](const std::vector<DicomTag>& tags)
    {
      this->tree->clear();
      this->tree->addTopLevelItems(ItemsOf(tags));
      this->tree->expandAll();
      for (int column = 0; column < TagValue; ++column)
      {
        this->tree->resizeColumnToContents(column);
      }
      this->status->setText(tr("%1: attributes: %2")
                              .arg(QString::fromStdString(this->series->Name(index)))
                              .arg(tags.size()));
      ShowMatching(this->tree, this->search->text());
    });
}

QString TagsWindow::SelectedText() const
{
  const bool isAll = this->tree->selectedItems().isEmpty();
  QStringList lines;
  for (QTreeWidgetItemIterator item(this->tree, QTreeWidgetItemIterator::NotHidden); *item; ++item)
  {
    if (isAll || (*item)->isSelected())
    {
      lines.append(LineOf(**item));
    }
  }
  return lines.join('\n');
}

void TagsWindow::Copy()
{
  QApplication::clipboard()->setText(this->SelectedText());
}

}
