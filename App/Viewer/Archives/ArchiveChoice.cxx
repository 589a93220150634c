#include "Viewer/Archives/ArchiveChoice.h"

#include "Viewer/Archives/ArchiveForm.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>

#include <algorithm>

namespace varimarch
{

namespace
{

const QString LastArchiveKey = QStringLiteral("lastArchive");

}

ArchiveChoice::ArchiveChoice(QWidget* parent)
  : QWidget(parent)
  , archives(KeptArchives())
  , box(new QComboBox)
  , edit(new QPushButton(tr("Edit…")))
  , remove(new QPushButton(tr("Remove")))
{
  auto* const add = new QPushButton(tr("Add…"));
  add->setObjectName("addArchive");
  this->box->setObjectName("archives");
  this->box->setAccessibleName(tr("Archive"));
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Archive")));
  row->addWidget(this->box, 1);
  for (QPushButton* const button : { add, this->edit, this->remove })
  {
    button->setAutoDefault(false);
    row->addWidget(button);
  }
  connect(add, &QPushButton::clicked, this, &ArchiveChoice::Add);
  connect(this->edit, &QPushButton::clicked, this, &ArchiveChoice::Edit);
  connect(this->remove, &QPushButton::clicked, this, &ArchiveChoice::Remove);
  connect(this->box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    &ArchiveChoice::KeepChoice);
  this->List(QSettings().value(LastArchiveKey).toInt());
}

void ArchiveChoice::List(int chosen)
{
  {
    const QSignalBlocker quiet(this->box);
    this->box->clear();
    for (const NamedArchive& archive : this->archives)
    {
      this->box->addItem(archive.name);
    }
    this->box->setCurrentIndex(std::clamp(chosen, -1, this->archives.size() - 1));
  }
  this->edit->setEnabled(!this->archives.isEmpty());
  this->remove->setEnabled(!this->archives.isEmpty());
  this->KeepChoice();
}

void ArchiveChoice::KeepChoice()
{
  QSettings().setValue(LastArchiveKey, this->box->currentIndex());
  emit this->Changed();
}

std::optional<NamedArchive> ArchiveChoice::Chosen() const
{
  const int row = this->box->currentIndex();
  return row < 0 ? std::nullopt : std::optional(this->archives[row]);
}

void ArchiveChoice::Add()
{
  this->EditRow(this->archives.size(), {});
}

void ArchiveChoice::Edit()
{
  const int row = this->box->currentIndex();
  this->EditRow(row, this->archives[row]);
}

void ArchiveChoice::EditRow(int row, const NamedArchive& archive)
{
  auto* const form = new ArchiveForm(archive, this);
  form->setAttribute(Qt::WA_DeleteOnClose);
  connect(form, &QDialog::accepted, this,
    [this, row, form]
    {
      if (row == this->archives.size())
      {
        this->archives.append(form->Edited());
      }
      else
      {
        this->archives[row] = form->Edited();
      }
      KeepArchives(this->archives);
      this->List(row);
    });
  form->open();
}

void ArchiveChoice::Remove()
{
  const int row = this->box->currentIndex();
  this->archives.remove(row);
  KeepArchives(this->archives);
  this->List(std::max(0, row - 1));
}

}
