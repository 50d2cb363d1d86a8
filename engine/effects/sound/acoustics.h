// How walls, edges and rooms carry sound: closed forms in SI units.
#pragma once

namespace plumbline::effects {

/// Share of the pressure that gets through a wall of so much mass per area: the mass law at normal
/// incidence.
float share_through_wall(float mass_kgpm2, float frequency_hz);

/// Share of the pressure that bends round one edge when the way over it is `detour_m` longer than
/// the straight one (Kurze and Anderson): 0.56 where the edge just meets the straight way.
float share_round_edge(float detour_m, float frequency_hz);

/// Time in which the sound of a room falls by 60 dB (Sabine); endless where nothing absorbs.
float reverberation_s(float volume_m3, float absorption_m2);

/// Of a room's steady sound against the direct sound of the same source 1 m away: the root of
/// 16 pi / absorption.
float reverberant_share(float absorption_m2);

/// Power of water that lands, W: from litres a second, the speed at the nozzle and how far
/// below it the water lands.
float water_power_W(float flow_lps, float speed_mps, float fall_m, float gravity_mps2);

}  // namespace plumbline::effects
