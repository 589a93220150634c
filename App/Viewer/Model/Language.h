#ifndef Varimarch_Viewer_Language_h
#define Varimarch_Viewer_Language_h

#include <QString>
#include <QVector>

class QCoreApplication;

namespace varimarch
{

struct Language
{
  QString code; ///< "de"; empty: the language of the system
  QString name; ///< in the language itself: "Deutsch"
};

/// Languages of the program, English first.
QVector<Language> Languages();

/// The user's choice, kept in the settings.
QString ChosenLanguage();
void ChooseLanguage(const QString& code);

/// Sets the language of all widgets created from now on, and the way they write numbers. Empty: the
/// system's language, if available. Numbers in files stay as in C.
void Speak(const QString& code, QCoreApplication* application);

}

#endif
