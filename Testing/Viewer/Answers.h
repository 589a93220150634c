#ifndef Varimarch_Testing_Answers_h
#define Varimarch_Testing_Answers_h

#include "Viewer/View/PictureExport.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

namespace varimarch
{

/// Answers the dialogs that open while it exists, as a user would.
class Answers
{
public:
  /// @param button    pressed in questions
  /// @param fileName  typed where a file is to be saved
  Answers(QMessageBox::StandardButton button, const QString& fileName)
    : button(button)
    , fileName(fileName)
  {
    QObject::connect(&this->timer, &QTimer::timeout, [this] { this->Answer(); });
    this->timer.start(20);
  }

  int Questions() const { return this->questions; }
  QString LastQuestion() const { return this->lastQuestion; }

private:
  void Answer()
  {
    QWidget* const dialog = QApplication::activeModalWidget();
    if (auto* const box = qobject_cast<QMessageBox*>(dialog))
    {
      ++this->questions;
      this->lastQuestion = box->text();
      box->button(this->button)->click();
    }
    else if (auto* const file = qobject_cast<QFileDialog*>(dialog))
    {
      auto* const name = file->findChild<QLineEdit*>("fileNameEdit");
      name->setText(this->fileName);
      QTest::keyClick(name, Qt::Key_Return);
    }
    else if (auto* const exported = qobject_cast<ExportDialog*>(dialog))
    {
      // Queued, since a timer rests while it waits for the dialog that this opens.
      QMetaObject::invokeMethod(
        exported->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save), "click",
        Qt::QueuedConnection);
    }
  }

  QMessageBox::StandardButton button;
  QString fileName;
  QString lastQuestion;
  int questions = 0;
  QTimer timer;
};

}

#endif
