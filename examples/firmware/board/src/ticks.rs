//! A counter of instructions, exact under QEMU's `-icount shift=0`, where one instruction is one
//! nanosecond.

/// A running counter. Cortex-M: SysTick on the core's clock, 24 bits. RISC-V: `minstret`.
pub struct Ticks {
    start: u32,
    #[cfg(target_arch = "arm")]
    timer: cortex_m::peripheral::SYST,
}

impl Ticks {
    /// Instructions in two ticks: the clock is 25 MHz on mps2 and 16 MHz on microbit.
    pub const INSTRUCTIONS_IN_TWO: u32 = if cfg!(target_arch = "riscv32") {
        2
    } else if cfg!(board = "microbit") {
        125
    } else {
        80
    };

    /// Ticks after which [`elapsed`](Ticks::elapsed) starts again from 0.
    pub const PERIOD: u64 = if cfg!(target_arch = "arm") {
        1 << 24
    } else {
        1 << 32
    };
}

#[cfg(target_arch = "arm")]
impl Ticks {
    /// Starts the counter.
    ///
    /// # Panics
    /// If it was started before.
    pub fn start() -> Self {
        let mut timer = cortex_m::Peripherals::take().expect("started once").SYST;
        timer.set_clock_source(cortex_m::peripheral::syst::SystClkSource::Core);
        timer.set_reload(Self::PERIOD as u32 - 1);
        timer.clear_current();
        timer.enable_counter();
        // The first period begins when the counter is next clocked, one tick from here.
        while cortex_m::peripheral::SYST::get_current() == 0 {}
        let start = cortex_m::peripheral::SYST::get_current();
        Ticks { start, timer }
    }

    /// Ticks since the start or the last [`restart`](Ticks::restart), modulo
    /// [`PERIOD`](Ticks::PERIOD).
    #[inline(always)]
    pub fn elapsed(&self) -> u32 {
        // It counts downwards.
        self.start
            .wrapping_sub(cortex_m::peripheral::SYST::get_current())
            % Self::PERIOD as u32
    }

    /// Counts from here.
    #[inline(always)]
    pub fn restart(&mut self) {
        self.start = cortex_m::peripheral::SYST::get_current();
    }

    /// Stops the counter.
    pub fn stop(mut self) {
        self.timer.disable_counter();
    }
}

#[cfg(target_arch = "riscv32")]
impl Ticks {
    /// Starts the counter.
    pub fn start() -> Self {
        Ticks { start: now() }
    }

    /// Instructions since the start or the last [`restart`](Ticks::restart), modulo
    /// [`PERIOD`](Ticks::PERIOD).
    #[inline(always)]
    pub fn elapsed(&self) -> u32 {
        now().wrapping_sub(self.start)
    }

    /// Counts from here.
    #[inline(always)]
    pub fn restart(&mut self) {
        self.start = now();
    }

    /// Stops the counter.
    pub fn stop(self) {}
}

#[cfg(target_arch = "riscv32")]
#[inline(always)]
fn now() -> u32 {
    riscv::register::minstret::read() as u32
}
