// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/CalibrationFiles.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "devices/common/UserFolder.h"

namespace palpate
{
namespace
{

constexpr const char* before = ".before";
constexpr const char* unfinished = ".part";
constexpr std::streamsize mostRead = 8192; // more than any calibration has

/// FNV-1a: tells names apart that look alike once their odd characters are gone.
std::string fingerprint(const std::string& text)
{
  std::uint64_t hash = 14695981039346656037ULL;
  for (const unsigned char c : text)
  {
    hash = (hash ^ c) * 1099511628211ULL;
  }
  std::array<char, 20> digits{};
  std::snprintf(digits.data(), digits.size(), "-%08x", static_cast<unsigned>(hash >> 32));
  return digits.data();
}

std::string plain(const std::string& text)
{
  constexpr std::size_t longest = 100;
  std::string name = text.substr(0, longest);
  std::replace_if(
    name.begin(), name.end(),
    [](char c)
    { return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_'); },
    '_');
  return name == text ? name : name + fingerprint(text);
}

KeptCalibration readFile(const std::string& path, const std::string& device, const std::string& serial)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    const int error = errno;
    return { std::nullopt, error == ENOENT ? "" : path + ": cannot be read: " + std::strerror(error) };
  }
  std::string text(static_cast<std::size_t>(mostRead), '\0');
  file.read(text.data(), mostRead);
  if (file.bad() || (file.fail() && !file.eof()))
  {
    return { std::nullopt, path + ": cannot be read" };
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  auto parsed = parseCalibration(text);
  if (parsed.value && (parsed.value->serial != serial || parsed.value->device != device))
  {
    return { std::nullopt, path + ": the calibration belongs to another device (" + parsed.value->device +
                             ", serial number \"" + parsed.value->serial + "\")" };
  }
  return { std::move(parsed.value), parsed.problem.empty() ? "" : path + ": " + parsed.problem };
}

/// On the disk before it has its name: a power cut leaves the old file or the new one.
std::string writeFile(const std::string& path, const std::string& text)
{
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0)
  {
    return path + ": cannot be written: " + std::strerror(errno);
  }
  const ssize_t written = ::write(file, text.data(), text.size());
  const bool whole = written == static_cast<ssize_t>(text.size()) && ::fsync(file) == 0;
  const int error = errno;
  ::close(file);
  return whole ? "" : path + ": cannot be written: " + std::strerror(error);
}

} // namespace

std::string userCalibrationFolder(const char* xdgConfigHome, const char* home)
{
  return userFolder(xdgConfigHome, home, "calibration");
}

std::string calibrationFile(const std::string& folder, const std::string& device, const std::string& serial)
{
  return folder + '/' + plain(device) + (serial.empty() ? "" : "." + plain(serial)) + ".calibration";
}

std::string today()
{
  const std::time_t now = std::time(nullptr);
  std::tm day{};
  localtime_r(&now, &day);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &day);
  return text.data();
}

KeptCalibration loadCalibration(const std::string& folder, const std::string& device, const std::string& serial)
{
  if (folder.empty())
  {
    return {};
  }
  const std::string path = calibrationFile(folder, device, serial);
  KeptCalibration newest = readFile(path, device, serial);
  if (newest.value || newest.problem.empty())
  {
    return newest;
  }
  KeptCalibration older = readFile(path + before, device, serial);
  if (!older.value)
  {
    return newest;
  }
  // The damaged file may have allowed less stiff walls.
  older.value->held = HeldProof::Unfelt;
  return { std::move(older.value), newest.problem + "; the previous calibration is used" };
}

std::string takeBackTrust(
  const std::string& folder, const std::string& device, const std::string& serial, HeldProof proof)
{
  if (proof == HeldProof::Felt || proof == HeldProof::Unfelt)
  {
    return {};
  }
  KeptCalibration kept = loadCalibration(folder, device, serial);
  if (!kept.value || kept.value->held != HeldProof::Felt)
  {
    return {};
  }
  kept.value->held = proof;
  return saveCalibration(folder, *kept.value);
}

std::string saveCalibration(const std::string& folder, const Calibration& calibration)
{
  namespace fs = std::filesystem;
  const std::string refused = calibration.refusal();
  if (folder.empty() || !refused.empty())
  {
    return folder.empty() ? "the calibration is not saved: there is no folder for calibrations"
                          : "the calibration is not saved: " + refused;
  }
  const std::string path = calibrationFile(folder, calibration.device, calibration.serial);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
  {
    return folder + ": the folder cannot be created: " + error.message();
  }
  Calibration kept = calibration;
  kept.held = calibration.serial.empty() ? HeldProof::Unfelt : calibration.held;
  std::string problem = writeFile(path + unfinished, writeCalibration(kept));
  if (!problem.empty())
  {
    return problem;
  }
  // A damaged file must not push out the good one before it.
  if (readFile(path, calibration.device, calibration.serial).value)
  {
    fs::copy_file(path, path + before + unfinished, fs::copy_options::overwrite_existing, error);
    if (!error)
    {
      fs::rename(path + before + unfinished, path + before, error);
    }
  }
  if (!error)
  {
    fs::rename(path + unfinished, path, error);
  }
  return error ? path + ": cannot be written: " + error.message() : "";
}

} // namespace palpate
