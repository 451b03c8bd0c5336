// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/hid/report/ReportDescriptor.h"

/// Usages of the Physical Interface Devices page (USB Device Class Definition for PID 1.0), and the few others it
/// needs.
namespace palpate::pid
{

inline constexpr HidUsage page = 0x0F0000;

// Reports, each named by the collection around its fields.
inline constexpr HidUsage setEffect = page | 0x21, setCondition = page | 0x5F, setPeriodic = page | 0x6E,
                          setConstantForce = page | 0x73, effectOperation = page | 0x77, blockFree = page | 0x90,
                          deviceControlReport = page | 0x95, deviceControl = page | 0x96,
                          deviceGainReport = page | 0x7D, createEffect = page | 0xAB, blockLoad = page | 0x89,
                          pool = page | 0x7F, stateReport = page | 0x92;

// Fields.
inline constexpr HidUsage blockIndex = page | 0x22, parameterOffset = page | 0x23, duration = page | 0x50,
                          samplePeriod = page | 0x51, effectGain = page | 0x52, triggerButton = page | 0x53,
                          repeatInterval = page | 0x54, axesEnable = page | 0x55, directionEnable = page | 0x56,
                          direction = page | 0x57, startDelay = page | 0xA7;
inline constexpr HidUsage centreOffset = page | 0x60, positiveCoefficient = page | 0x61,
                          negativeCoefficient = page | 0x62, positiveSaturation = page | 0x63,
                          negativeSaturation = page | 0x64, deadBand = page | 0x65;
inline constexpr HidUsage offset = page | 0x6F, magnitude = page | 0x70, phase = page | 0x71, period = page | 0x72;
inline constexpr HidUsage loopCount = page | 0x7C, deviceGain = page | 0x7E;
inline constexpr HidUsage deviceManaged = page | 0xA9, largestEffectCount = page | 0x83;

// Effect types.
inline constexpr HidUsage constantForce = page | 0x26, square = page | 0x30, sine = page | 0x31, triangle = page | 0x32,
                          sawtoothUp = page | 0x33, sawtoothDown = page | 0x34, spring = page | 0x40,
                          damper = page | 0x41;

// Selectors.
inline constexpr HidUsage start = page | 0x79, startSolo = page | 0x7A, stop = page | 0x7B;
inline constexpr HidUsage enableActuators = page | 0x97, disableActuators = page | 0x98, stopAll = page | 0x99,
                          reset = page | 0x9A;
inline constexpr HidUsage loaded = page | 0x8C, full = page | 0x8D, loadError = page | 0x8E;

// Device state.
inline constexpr HidUsage actuatorsEnabled = page | 0xA0, effectPlaying = page | 0x94, actuatorPower = page | 0xA6,
                          paused = page | 0x9F, safetySwitch = page | 0xA4, overrideSwitch = page | 0xA5;

// Other pages.
inline constexpr HidUsage axisX = 0x010030, axisY = 0x010031, firstOrdinal = 0x0A0001, buttonPage = 0x090000;

} // namespace palpate::pid
