// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "BuildPaths.h"

namespace handwheel {

inline constexpr int kLongestRun = 600'000;  // ms; with sanitizers some runs take minutes

// The output and exit code of the program. The code is -1 if the program crashed or did not end.
struct Ran {
  int code = -1;
  QByteArray out;
  QByteArray err;
};

// Returns the output of the program as JSON. The result is a discarded value if the output is not JSON.
inline nlohmann::json jsonOf(const Ran& ran) {
  return nlohmann::json::parse(ran.out.toStdString(), nullptr, false);
}

inline QProcessEnvironment environmentWith(const QString& locale) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("LC_ALL", locale);
  environment.insert("LANG", locale);
  return environment;
}

// Returns the result of a finished run. A crash, or the report of a sanitizer, is printed in words by which
// tools/run-tests tells it from a failed comparison.
inline Ran resultOf(QProcess& process) {
  const Ran ran{process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
  const bool hasCrashed = process.exitStatus() != QProcess::NormalExit;
  if (hasCrashed || ran.err.contains("Sanitizer") || ran.err.contains("runtime error:"))
    qWarning("the program crashed: %s\n%s", qPrintable(process.arguments().join(' ')), ran.err.constData());
  return hasCrashed ? Ran{} : ran;
}

// Runs a program in a folder and waits until it ends.
inline Ran runProgram(const QString& program, const QString& folder, const QStringList& words,
                      const QString& locale = "C") {
  QProcess process;
  process.setWorkingDirectory(folder);
  process.setProcessEnvironment(environmentWith(locale));
  process.start(program, words);
  return process.waitForFinished(kLongestRun) ? resultOf(process) : Ran{};
}

// Runs the built program in a folder.
inline Ran runIn(const QString& folder, const QStringList& words, const QString& locale = "C") {
  return runProgram(test::programPath(), folder, words, locale);
}

// Returns true if a process has installed a handler for the signal, according to the mask that the kernel reports.
inline bool catches(qint64 process, int signal) {
  QFile status(QString("/proc/%1/status").arg(process));
  if (!status.open(QIODevice::ReadOnly)) return false;
  for (const QByteArray& line : status.readAll().split('\n')) {
    if (line.startsWith("SigCgt:")) return line.mid(7).trimmed().toULongLong(nullptr, 16) >> (signal - 1) & 1;
  }
  return false;
}

// A temporary folder for one test, in which the program is run.
class Fixture {
 public:
  void put(const QString& name, const QByteArray& content) const {
    QFile file(m_folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) qFatal("cannot write a test file");
  }
  QByteArray content(const QString& name) const {
    QFile file(m_folder.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  nlohmann::json json(const QString& name) const { return nlohmann::json::parse(content(name).toStdString()); }
  QStringList names() const {
    return QDir(path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
  }
  QString path() const { return m_folder.path(); }
  Ran run(const QStringList& words, const QString& locale = "C") const { return runIn(path(), words, locale); }
  nlohmann::json inspected(const QString& name) const { return jsonOf(run({"inspect", name, "--json"})); }

 private:
  QTemporaryDir m_folder;
};

}  // namespace handwheel
