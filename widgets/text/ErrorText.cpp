// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/ErrorText.h"

#include "text/ErrorWords.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct ErrorWords {
  Q_DECLARE_TR_FUNCTIONS(ErrorText)
};

// Nothing that a terminal would obey, and no new line.
QString harmless(const std::string& bytes) {
  QString text = QString::fromStdString(bytes);
  for (QChar& c : text) {
    if (!c.isPrint() && !c.isSurrogate()) c = QChar::ReplacementCharacter;
  }
  return text;
}

QString argument(const Error& error, std::size_t i) {
  return i < error.arguments.size() ? errorArgument(harmless(error.arguments[i]).simplified()) : QString();
}

// The parts that there are, as a list: "scan.stl, line 7".
QString listed(const QStringList& parts) {
  QString list = parts.value(0);
  for (const QString& part : parts.mid(1)) list = ErrorWords::tr("%1, %2").arg(list, part);
  return list;
}

// ".stl, .ply or .obj": the arguments from there on.
QString alternatives(const Error& error, std::size_t from) {
  QStringList all;
  for (std::size_t i = from; i < error.arguments.size(); ++i) all << argument(error, i);
  if (all.size() < 2) return listed(all);
  const QString last = all.takeLast();
  return ErrorWords::tr("%1 or %2").arg(listed(all), last);
}

// "the file ends too early: 12 facets expected, 9 found", leaving out what is not known.
QString counts(const QString& what, const QString& expected, const QString& found) {
  QStringList parts;
  if (!expected.isEmpty()) parts << ErrorWords::tr("%1 expected").arg(expected);
  if (!found.isEmpty()) parts << ErrorWords::tr("%1 found").arg(found);
  return ErrorWords::tr("%1: %2").arg(what, listed(parts));
}

QString tooLarge(const QString& what, const QString& count, const QString& limit) {
  if (count.isEmpty()) return ErrorWords::tr("the file is too large (more than %1 %2)").arg(limit, what);
  return ErrorWords::tr("the file is too large (%1 %2, at most %3 can be opened)").arg(count, what, limit);
}

QString unexpected(const QString& expected, const QString& found) {
  if (expected.isEmpty()) return ErrorWords::tr("'%1' makes no sense here").arg(found);
  if (found.isEmpty()) return ErrorWords::tr("%1 was expected, but nothing follows").arg(expected);
  return ErrorWords::tr("%1 was expected, '%2' was found").arg(expected, found);
}

QString whatHappened(const Error& error) {
  const QString a = argument(error, 0);
  const QString b = argument(error, 1);
  const QString c = argument(error, 2);
  switch (error.code) {
    case ErrorCode::Cancelled:
      return ErrorWords::tr("cancelled");
    case ErrorCode::OutOfMemory:
      return ErrorWords::tr("there is not enough memory");
    case ErrorCode::FileMissing:
      return ErrorWords::tr("there is no such file");
    case ErrorCode::FileUnreadable:
      return ErrorWords::tr("the file cannot be read (%1)").arg(a);
    case ErrorCode::FileEmpty:
      return ErrorWords::tr("the file is empty");
    case ErrorCode::FileTooLarge:
      return tooLarge(a, b, c);
    case ErrorCode::FormatUnknown:
      return ErrorWords::tr("this is no file that Handwheel knows");
    case ErrorCode::ExtensionUnknown:
      return a.isEmpty() ? ErrorWords::tr("the name has no ending, which would say the format")
                         : ErrorWords::tr("the ending '%1' stands for no format that this can be written in").arg(a);
    case ErrorCode::HeaderMalformed:
      return ErrorWords::tr("the header is malformed: %1 is missing").arg(a);
    case ErrorCode::TextEncoding:
      return ErrorWords::tr("the text is in %1, which cannot be read").arg(a);
    case ErrorCode::TokenUnexpected:
      return unexpected(a, b);
    case ErrorCode::NumberMalformed:
      return ErrorWords::tr("'%1' is not a number").arg(a);
    case ErrorCode::NumberNotFinite:
      return ErrorWords::tr("the coordinate '%1' is not a finite number").arg(a);
    case ErrorCode::IndexOutOfRange:
      return ErrorWords::tr("a face uses vertex %1, but the file has %2 vertices").arg(a, b);
    case ErrorCode::VertexUnreadable:
      return ErrorWords::tr("a face uses vertex %1, which could not be read").arg(a);
    case ErrorCode::PolygonTooComplex:
      return ErrorWords::tr("a face with %1 corners was cut into triangles as if it were convex").arg(a);
    case ErrorCode::PolygonTooSmall:
      return ErrorWords::tr("a face has fewer than three corners (%1)").arg(a);
    case ErrorCode::DataTruncated:
      return ErrorWords::tr("the file ends too early (%1)").arg(counts(a, b, c));
    case ErrorCode::CountMismatch:
      return ErrorWords::tr("the file contradicts itself (%1)").arg(counts(a, b, c));
    case ErrorCode::TypeUnknown:
      return ErrorWords::tr("the data type '%1' is not known").arg(a);
    case ErrorCode::NoTriangles:
      return error.place.kind == InputPosition::Kind::None
                 ? ErrorWords::tr("the file holds no triangle")
                 : ErrorWords::tr("the file is damaged here, and none of its triangles can be read");
    case ErrorCode::WriteFailed:
      return ErrorWords::tr("the file could not be written (%1)").arg(a);
    case ErrorCode::CheckFailed:
      return ErrorWords::tr("the written file does not read back as it should (%1), so it was not kept").arg(a);
    case ErrorCode::ArchiveMalformed:
      return ErrorWords::tr("the archive cannot be read (%1)").arg(a);
    case ErrorCode::EntryMissing:
      return ErrorWords::tr("the part '%1' is missing").arg(a);
    case ErrorCode::EntryDamaged:
      return ErrorWords::tr("the part '%1' is damaged").arg(a);
    case ErrorCode::VersionNewer:
      return ErrorWords::tr("the file has version %1 of the format; this program knows up to version %2").arg(a, b);
    case ErrorCode::KindUnknown:
      return ErrorWords::tr("the file holds a '%1', a kind of document that this program does not know").arg(a);
    case ErrorCode::ElementMalformed:
      return ErrorWords::tr("the element '%1' is malformed: %2").arg(a, b);
    case ErrorCode::ReferenceMissing:
      return ErrorWords::tr("%1 '%2' is named, but cannot be found").arg(a, b);
    case ErrorCode::ValueOutOfRange:
      return ErrorWords::tr("%1 cannot be %2; it must lie between %3 and %4").arg(a, b, c, argument(error, 3));
    case ErrorCode::Unsupported:
      return ErrorWords::tr("%1 is not supported").arg(a);
    case ErrorCode::PluginVersion:
      return ErrorWords::tr("the plugin was made for another version of Handwheel (%1, here %2)").arg(a, b);
    case ErrorCode::PluginBroken:
      return ErrorWords::tr("the plugin cannot be used (%1)").arg(a);
    case ErrorCode::DeviceUnreachable:
      return ErrorWords::tr("the device cannot be reached (%1)").arg(a);
    case ErrorCode::DeviceNotResponding:
      return ErrorWords::tr("the device does not answer as it should (%1)").arg(a);
    case ErrorCode::StepMalformed:
      return ErrorWords::tr("the step cannot be done: %1").arg(a);
    case ErrorCode::LibraryFailed:
      return ErrorWords::tr("the library %1 gave up (%2)").arg(a, b);
  }
  return {};
}

QString where(const Error& error) {
  const QString number = QString::number(error.place.value);
  switch (error.place.kind) {
    case InputPosition::Kind::None:
      return {};
    case InputPosition::Kind::Byte:
      return ErrorWords::tr("byte %1").arg(number);
    case InputPosition::Kind::Line:
      return ErrorWords::tr("line %1").arg(number);
  }
  return {};
}

}  // namespace

QString errorSentence(const Error& error) {
  QStringList origin;
  if (!error.subject.empty()) origin << harmless(error.subject);
  if (const QString place = where(error); !place.isEmpty()) origin << place;
  QString sentence = ErrorWords::tr("%1.").arg(whatHappened(error));
  if (!origin.isEmpty()) sentence = ErrorWords::tr("%1: %2").arg(listed(origin), sentence);
  // File names are left as they are.
  return error.subject.empty() ? sentence.left(1).toUpper() + sentence.mid(1) : sentence;
}

QString errorAdvice(const Error& error) {
  switch (error.code) {
    case ErrorCode::Cancelled:
      return {};
    case ErrorCode::OutOfMemory:
      return ErrorWords::tr("Close other documents or programs, or try a model with fewer triangles.");
    case ErrorCode::FileMissing:
      return ErrorWords::tr("Check the name, or whether the file was moved.");
    case ErrorCode::FileUnreadable:
      return ErrorWords::tr("Name a file that you may read, and check that its disk is connected.");
    case ErrorCode::FileEmpty:
      return ErrorWords::tr("Export or copy the file again.");
    case ErrorCode::FileTooLarge:
      return ErrorWords::tr("Reduce or split the model in the program that made it.");
    case ErrorCode::FormatUnknown:
      return error.arguments.empty()
                 ? ErrorWords::tr("Choose another file.")
                 : ErrorWords::tr("Handwheel reads files that end in %1.").arg(alternatives(error, 0));
    case ErrorCode::ExtensionUnknown:
      return ErrorWords::tr("Use a name that ends in %1.").arg(alternatives(error, 1));
    case ErrorCode::TextEncoding:
      return ErrorWords::tr("Save the file as UTF-8 text or in a binary format.");
    case ErrorCode::HeaderMalformed:
    case ErrorCode::TypeUnknown:
      return ErrorWords::tr("Export the file again; its beginning is damaged or of a variant that is not supported.");
    case ErrorCode::TokenUnexpected:
    case ErrorCode::NumberMalformed:
    case ErrorCode::NumberNotFinite:
    case ErrorCode::IndexOutOfRange:
    case ErrorCode::VertexUnreadable:
    case ErrorCode::PolygonTooSmall:
    case ErrorCode::DataTruncated:
    case ErrorCode::CountMismatch:
      return ErrorWords::tr(
          "Export or copy the file again, or open only what is readable (on the command line: --partial).");
    case ErrorCode::PolygonTooComplex:
      return ErrorWords::tr("Check the shape of that face, or export the model as triangles.");
    case ErrorCode::NoTriangles:
      return error.place.kind == InputPosition::Kind::None
                 ? ErrorWords::tr(
                       "Export the model as a surface of triangles; points and curves alone cannot be repaired.")
                 : ErrorWords::tr("Export or copy the file again.");
    case ErrorCode::WriteFailed:
      return ErrorWords::tr("Check the free space and that you may write there, or choose another place.");
    case ErrorCode::CheckFailed:
      return ErrorWords::tr("An earlier file of that name is untouched. Save in another format, for example PLY.");
    case ErrorCode::ArchiveMalformed:
    case ErrorCode::EntryMissing:
    case ErrorCode::EntryDamaged:
      return ErrorWords::tr("Copy the file again, or go back to an earlier copy of it.");
    case ErrorCode::VersionNewer:
    case ErrorCode::KindUnknown:
      return ErrorWords::tr("Open it with a newer version of Handwheel.");
    case ErrorCode::ElementMalformed:
      return ErrorWords::tr("Mend the file at this place, or export it again.");
    case ErrorCode::ReferenceMissing:
      return ErrorWords::tr("Put the missing file where the other one expects it.");
    case ErrorCode::ValueOutOfRange:
      return ErrorWords::tr("Enter a value within these limits.");
    case ErrorCode::PluginVersion:
    case ErrorCode::PluginBroken:
      return ErrorWords::tr("Install a plugin that was made for this version, or remove the file.");
    case ErrorCode::DeviceUnreachable:
      return ErrorWords::tr("Check that it is plugged in, that no other program uses it and that you may use it.");
    case ErrorCode::DeviceNotResponding:
      return ErrorWords::tr("Switch it off and on again, or try another port.");
    case ErrorCode::StepMalformed:
      return ErrorWords::tr("'handwheel help edit' lists the steps; loops are numbered as 'handwheel inspect' does.");
    case ErrorCode::Unsupported:
    case ErrorCode::LibraryFailed:
      return ErrorWords::tr("Export the model in another way or another format.");
  }
  return {};
}

}  // namespace handwheel
