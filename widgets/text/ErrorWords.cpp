// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/ErrorWords.h"

#include <QCoreApplication>
#include <algorithm>
#include <optional>

namespace handwheel {

namespace {

constexpr qsizetype kLongestQuote = 48;  // characters of a foreign file shown in a sentence,
constexpr qsizetype kLongestName = 400;  // and those of the name of a file, whose end tells most

// The phrases that the core, most of which knows no Qt, puts into its errors. A phrase that is missing here is shown in
// English. %1 stands for a name or a number; the first phrase that fits counts.
constexpr const char* kPhrases[] = {
    // {what} of counts
    QT_TRANSLATE_NOOP("ErrorWord", "attributes"),
    QT_TRANSLATE_NOOP("ErrorWord", "bodies"),
    QT_TRANSLATE_NOOP("ErrorWord", "bytes"),
    QT_TRANSLATE_NOOP("ErrorWord", "columns"),
    QT_TRANSLATE_NOOP("ErrorWord", "dimensions"),
    QT_TRANSLATE_NOOP("ErrorWord", "elements"),
    QT_TRANSLATE_NOOP("ErrorWord", "entries"),
    QT_TRANSLATE_NOOP("ErrorWord", "events"),
    QT_TRANSLATE_NOOP("ErrorWord", "faces"),
    QT_TRANSLATE_NOOP("ErrorWord", "faces that can be triangulated"),
    QT_TRANSLATE_NOOP("ErrorWord", "facets"),
    QT_TRANSLATE_NOOP("ErrorWord", "numbers"),
    QT_TRANSLATE_NOOP("ErrorWord", "parts"),
    QT_TRANSLATE_NOOP("ErrorWord", "parts that can be read"),
    QT_TRANSLATE_NOOP("ErrorWord", "poles"),
    QT_TRANSLATE_NOOP("ErrorWord", "segments"),
    QT_TRANSLATE_NOOP("ErrorWord", "strips"),
    QT_TRANSLATE_NOOP("ErrorWord", "ticks"),
    QT_TRANSLATE_NOOP("ErrorWord", "ticks of the recording '%1'"),
    QT_TRANSLATE_NOOP("ErrorWord", "triangles"),
    QT_TRANSLATE_NOOP("ErrorWord", "vertices"),
    // … was expected
    QT_TRANSLATE_NOOP("ErrorWord", "a count"),
    QT_TRANSLATE_NOOP("ErrorWord", "a number"),
    QT_TRANSLATE_NOOP("ErrorWord", "a statement of the format"),
    QT_TRANSLATE_NOOP("ErrorWord", "a vertex number"),
    QT_TRANSLATE_NOOP("ErrorWord", "a whole number"),
    QT_TRANSLATE_NOOP("ErrorWord", "the end of the line"),
    QT_TRANSLATE_NOOP("ErrorWord", "the number of faces"),
    QT_TRANSLATE_NOOP("ErrorWord", "the number of vertices"),
    // … is named, but cannot be found
    QT_TRANSLATE_NOOP("ErrorWord", "the 3D model"),
    QT_TRANSLATE_NOOP("ErrorWord", "the body"),
    QT_TRANSLATE_NOOP("ErrorWord", "the file"),
    QT_TRANSLATE_NOOP("ErrorWord", "the joint"),
    QT_TRANSLATE_NOOP("ErrorWord", "the link"),
    QT_TRANSLATE_NOOP("ErrorWord", "the mesh"),
    QT_TRANSLATE_NOOP("ErrorWord", "the object"),
    QT_TRANSLATE_NOOP("ErrorWord", "the package"),
    QT_TRANSLATE_NOOP("ErrorWord", "the property"),
    QT_TRANSLATE_NOOP("ErrorWord", "the setting"),
    QT_TRANSLATE_NOOP("ErrorWord", "the firmware file"),
    // the device does not answer as it should (…), cannot be reached (…); the plugin cannot be used (…)
    QT_TRANSLATE_NOOP("ErrorWord", "a packet of the firmware"),
    QT_TRANSLATE_NOOP("ErrorWord", "an inventory with an Inverse3"),
    QT_TRANSLATE_NOOP("ErrorWord", "the bootloader's greeting"),
    QT_TRANSLATE_NOOP("ErrorWord", "the echo of the first byte"),
    QT_TRANSLATE_NOOP("ErrorWord", "the firmware's echo"),
    QT_TRANSLATE_NOOP("ErrorWord", "the handshake of a WebSocket"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not there"),
    QT_TRANSLATE_NOOP("ErrorWord", "its position"),
    QT_TRANSLATE_NOOP("ErrorWord", "unplugged"),
    QT_TRANSLATE_NOOP("ErrorWord", "the process that guards its motors has ended"),
    QT_TRANSLATE_NOOP("ErrorWord", "it brings no driver"),
    QT_TRANSLATE_NOOP("ErrorWord", "there is already a driver '%1'"),
    // … is not supported
    QT_TRANSLATE_NOOP("ErrorWord", "XML that declares entities"),
    QT_TRANSLATE_NOOP("ErrorWord", "a geometry that is not a mesh"),
    QT_TRANSLATE_NOOP("ErrorWord", "a link to a file name that is not UTF-8"),
    QT_TRANSLATE_NOOP("ErrorWord", "a skinned mesh"),
    QT_TRANSLATE_NOOP("ErrorWord", "a xacro file that is not expanded to URDF"),
    QT_TRANSLATE_NOOP("ErrorWord", "setting %1"),
    QT_TRANSLATE_NOOP("ErrorWord", "the 3MF extension '%1'"),
    QT_TRANSLATE_NOOP("ErrorWord", "the floating joint '%1', which is treated as fixed,"),
    QT_TRANSLATE_NOOP("ErrorWord", "the planar joint '%1', which is treated as fixed,"),
    QT_TRANSLATE_NOOP("ErrorWord", "the mesh name '%1', which is not a file on this computer,"),
    QT_TRANSLATE_NOOP("ErrorWord", "the mesh name '%1', which leads too far away,"),
    QT_TRANSLATE_NOOP("ErrorWord", "the mesh name '%1', which leaves its package,"),
    QT_TRANSLATE_NOOP("ErrorWord", "the mesh name '%1', which is on another computer,"),
    QT_TRANSLATE_NOOP("ErrorWord", "the mesh name '%1', which names no package,"),
    QT_TRANSLATE_NOOP("ErrorWord", "the shape '%1'"),
    QT_TRANSLATE_NOOP("ErrorWord", "the shape %1"),
    // … cannot be 7; it must lie between
    QT_TRANSLATE_NOOP("ErrorWord", "a coordinate of the mesh"),
    QT_TRANSLATE_NOOP("ErrorWord", "an origin"),
    QT_TRANSLATE_NOOP("ErrorWord", "chord tolerance"),
    // of a turned part
    QT_TRANSLATE_NOOP("ErrorWord", "the number of samples is missing or impossible"),
    QT_TRANSLATE_NOOP("ErrorWord", "passes"),
    QT_TRANSLATE_NOOP("ErrorWord", "samples of the profile"),
    // the written file does not read back as it should
    QT_TRANSLATE_NOOP("ErrorWord", "it cannot be opened"),
    QT_TRANSLATE_NOOP("ErrorWord", "it contains no valid solid"),
    QT_TRANSLATE_NOOP("ErrorWord", "its triangles differ"),
    QT_TRANSLATE_NOOP("ErrorWord", "its volume differs"),
    // the file, the archive or the library
    QT_TRANSLATE_NOOP("ErrorWord", "Its directory is wrong"),
    QT_TRANSLATE_NOOP("ErrorWord", "Not a regular file"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is inconsistent"),
    QT_TRANSLATE_NOOP("ErrorWord", "it crashed on this file"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not a STEP file"),
    QT_TRANSLATE_NOOP("ErrorWord", "it takes more than %1 triangles"),
    QT_TRANSLATE_NOOP("ErrorWord", "it took longer than %1 s"),
    QT_TRANSLATE_NOOP("ErrorWord", "its answer is too large"),
    QT_TRANSLATE_NOOP("ErrorWord", "its answer is not valid"),
    QT_TRANSLATE_NOOP("ErrorWord", "its process cannot be started"),
    QT_TRANSLATE_NOOP("ErrorWord", "its surfaces have zero size"),
    QT_TRANSLATE_NOOP("ErrorWord", "none of its surfaces can be triangulated"),
    QT_TRANSLATE_NOOP("ErrorWord", "the faces do not close"),
    QT_TRANSLATE_NOOP("ErrorWord", "the faces do not join"),
    QT_TRANSLATE_NOOP("ErrorWord", "the file cannot be written"),
    QT_TRANSLATE_NOOP("ErrorWord", "the file contains no shape"),
    QT_TRANSLATE_NOOP("ErrorWord", "the file contains no surface"),
    QT_TRANSLATE_NOOP("ErrorWord", "the picture could not be packed"),
    QT_TRANSLATE_NOOP("ErrorWord", "the picture has no pixels"),
    QT_TRANSLATE_NOOP("ErrorWord", "the solid cannot be translated"),
    QT_TRANSLATE_NOOP("ErrorWord", "the system ended it; it may have run out of memory"),
    // the element is malformed:
    QT_TRANSLATE_NOOP("ErrorWord", "%1 of its polygons cannot be read"),
    QT_TRANSLATE_NOOP("ErrorWord", "a choice was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "a colour such as #b8bcc7 was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "a comment is too long"),
    QT_TRANSLATE_NOOP("ErrorWord", "a number was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "a pole is across the axis, too far away or not finite"),
    QT_TRANSLATE_NOOP("ErrorWord", "a rate or a time is not above zero"),
    QT_TRANSLATE_NOOP("ErrorWord", "a short list of keys is expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "a tag is too long"),
    QT_TRANSLATE_NOOP("ErrorWord", "a text is too long"),
    QT_TRANSLATE_NOOP("ErrorWord", "a text of at most 1000 bytes in UTF-8 was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "a text was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "a weight is missing, not positive or too large"),
    QT_TRANSLATE_NOOP("ErrorWord", "a whole number is expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "an object is expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "elements are nested too deeply"),
    QT_TRANSLATE_NOOP("ErrorWord", "it belongs to a closed loop of joints"),
    QT_TRANSLATE_NOOP("ErrorWord", "it contains itself"),
    QT_TRANSLATE_NOOP("ErrorWord", "the version of the format is missing"),
    QT_TRANSLATE_NOOP("ErrorWord", "it mimics itself"),
    QT_TRANSLATE_NOOP("ErrorWord", "its mimic factor or offset is too large"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has a document type"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has no limits, so it moves without limits"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has no links"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has no name"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has no shape"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has no type"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has no %1"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has too few poles"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is missing"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is nested too deeply"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not a length; metres are assumed"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not an object"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not JSON"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not an object"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not the root"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not twelve numbers"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is instanced too often, or within itself"),
    QT_TRANSLATE_NOOP("ErrorWord", "it lies on the axis"),
    QT_TRANSLATE_NOOP("ErrorWord", "it names no file"),
    QT_TRANSLATE_NOOP("ErrorWord", "it names no joint"),
    QT_TRANSLATE_NOOP("ErrorWord", "it names no %1"),
    QT_TRANSLATE_NOOP("ErrorWord", "its axis has no direction"),
    QT_TRANSLATE_NOOP("ErrorWord", "its degree must be 1, 2 or 3"),
    QT_TRANSLATE_NOOP("ErrorWord", "its joints form a closed loop"),
    QT_TRANSLATE_NOOP("ErrorWord", "its knots do not fit its poles"),
    QT_TRANSLATE_NOOP("ErrorWord", "its loops cannot be identified any more"),
    QT_TRANSLATE_NOOP("ErrorWord", "its lower limit is above the upper one"),
    QT_TRANSLATE_NOOP("ErrorWord", "its number %1 is already in use"),
    QT_TRANSLATE_NOOP("ErrorWord", "its object is of the type 'other'"),
    QT_TRANSLATE_NOOP("ErrorWord", "its pose cannot be used"),
    QT_TRANSLATE_NOOP("ErrorWord", "its geometry has no type"),
    QT_TRANSLATE_NOOP("ErrorWord", "its key is not a number"),
    QT_TRANSLATE_NOOP("ErrorWord", "its matrix is not a rotation"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is longer than its size"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not a regular file"),
    QT_TRANSLATE_NOOP("ErrorWord", "the position of the body"),
    QT_TRANSLATE_NOOP("ErrorWord", "cutting them again would take too long"),
    QT_TRANSLATE_NOOP("ErrorWord", "its scale is degenerate"),
    QT_TRANSLATE_NOOP("ErrorWord", "its size is not a length"),
    QT_TRANSLATE_NOOP("ErrorWord", "its transformation is not valid"),
    QT_TRANSLATE_NOOP("ErrorWord", "its triangles are inconsistent"),
    QT_TRANSLATE_NOOP("ErrorWord", "its type '%1' is not known"),
    QT_TRANSLATE_NOOP("ErrorWord", "its unit is '%1'"),
    QT_TRANSLATE_NOOP("ErrorWord", "its vertices have no positions"),
    QT_TRANSLATE_NOOP("ErrorWord", "link %1 already has a parent joint"),
    QT_TRANSLATE_NOOP("ErrorWord", "no joint connects it to %1"),
    QT_TRANSLATE_NOOP("ErrorWord", "one of its indices is not a number"),
    QT_TRANSLATE_NOOP("ErrorWord", "there are two of that name"),
    QT_TRANSLATE_NOOP("ErrorWord", "there is no such key"),
    QT_TRANSLATE_NOOP("ErrorWord", "they do not fit the mesh"),
    QT_TRANSLATE_NOOP("ErrorWord", "yes or no was expected"),
    // drawings and targets
    QT_TRANSLATE_NOOP("ErrorWord", "the number of segments is missing or impossible"),
    QT_TRANSLATE_NOOP("ErrorWord", "its radius is not above zero"),
    QT_TRANSLATE_NOOP("ErrorWord", "its code is no number"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has no extent"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has no value"),
    QT_TRANSLATE_NOOP("ErrorWord", "a command was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not one that SVG has"),
    QT_TRANSLATE_NOOP("ErrorWord", "a coordinate is too large"),
    QT_TRANSLATE_NOOP("ErrorWord", "its answer is not understood"),
    QT_TRANSLATE_NOOP("ErrorWord", "its outline differs"),
    QT_TRANSLATE_NOOP("ErrorWord", "there are no fonts"),
    QT_TRANSLATE_NOOP("ErrorWord", "the page cannot be painted"),
    // of lathes, programs and exercises
    QT_TRANSLATE_NOOP("ErrorWord", "a list was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "a nose radius is impossible"),
    QT_TRANSLATE_NOOP("ErrorWord", "a number was expected, or nothing"),
    QT_TRANSLATE_NOOP("ErrorWord", "a range ends before it begins"),
    QT_TRANSLATE_NOOP("ErrorWord", "a section has no corners, too many, or impossible ones"),
    QT_TRANSLATE_NOOP("ErrorWord", "a switch was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "a text in UTF-8 was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "a tool is impossible"),
    QT_TRANSLATE_NOOP("ErrorWord", "an object was expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "criteria"),
    QT_TRANSLATE_NOOP("ErrorWord", "feed and spindle speed must be above 0"),
    QT_TRANSLATE_NOOP("ErrorWord", "it has too few points"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is impossible"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is no object"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not 1"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not a list of the numbers that belong there"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is not known"),
    QT_TRANSLATE_NOOP("ErrorWord", "it is too long"),
    QT_TRANSLATE_NOOP("ErrorWord", "it names a criterion that there is not"),
    QT_TRANSLATE_NOOP("ErrorWord", "its kind is unknown"),
    QT_TRANSLATE_NOOP("ErrorWord", "its lists differ in length, or do not ascend"),
    QT_TRANSLATE_NOOP("ErrorWord", "its time is impossible"),
    QT_TRANSLATE_NOOP("ErrorWord", "lines"),
    QT_TRANSLATE_NOOP("ErrorWord", "nothing is left of the part"),
    QT_TRANSLATE_NOOP("ErrorWord", "numbers with “;” between them were expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "one of its numbers is impossible"),
    QT_TRANSLATE_NOOP("ErrorWord", "points"),
    QT_TRANSLATE_NOOP("ErrorWord", "points of two numbers each were expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "points were expected"),
    QT_TRANSLATE_NOOP("ErrorWord", "property"),
    QT_TRANSLATE_NOOP("ErrorWord", "rows"),
    QT_TRANSLATE_NOOP("ErrorWord", "steps"),
    QT_TRANSLATE_NOOP("ErrorWord", "the bore is longer than the part"),
    QT_TRANSLATE_NOOP("ErrorWord", "the bore is wider than the part"),
    QT_TRANSLATE_NOOP("ErrorWord", "there are too many"),
    QT_TRANSLATE_NOOP("ErrorWord", "there are two with this id"),
    QT_TRANSLATE_NOOP("ErrorWord", "there is no such choice"),
    QT_TRANSLATE_NOOP("ErrorWord", "too many sections, or no list"),
};

QString shortened(const QString& text) {
  const qsizetype longest = text.contains(QLatin1Char('/')) ? kLongestName : kLongestQuote;
  return text.size() > longest ? text.left(longest) + QChar(0x2026) : text;
}

// What %1 of the phrase stands for in the text; empty when it stands for nothing; none when the text is not the phrase.
std::optional<QString> nameWithin(const QString& text, QLatin1String phrase) {
  const qsizetype at = phrase.indexOf(QLatin1String("%1"));
  if (at < 0) return text == phrase ? std::optional(QString()) : std::nullopt;
  const QLatin1String before = phrase.first(at), after = phrase.sliced(at + 2);
  if (text.size() <= before.size() + after.size() || !text.startsWith(before) || !text.endsWith(after)) return {};
  return text.sliced(before.size(), text.size() - before.size() - after.size());
}

}  // namespace

QString errorArgument(const QString& english) {
  for (const char* phrase : kPhrases) {
    const std::optional<QString> name = nameWithin(english, QLatin1String(phrase));
    if (!name) continue;
    const QString translated = QCoreApplication::translate("ErrorWord", phrase);
    return name->isEmpty() ? translated : translated.arg(shortened(*name));
  }
  return shortened(english);
}

}  // namespace handwheel
