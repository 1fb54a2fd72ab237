//! What must not be reachable ends in a symbol that exists nowhere.

use core::alloc::{GlobalAlloc, Layout};

unsafe extern "C" {
    fn a_panic_is_reachable() -> !;
    // It has to return: a compiler may assume that allocation does.
    fn an_allocation_is_reachable(size: usize) -> *mut u8;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: an image that has this call does not link.
    unsafe { a_panic_is_reachable() }
}

struct Forbidden;

#[global_allocator]
static ALLOCATOR: Forbidden = Forbidden;

// SAFETY: an image that has these calls does not link.
unsafe impl GlobalAlloc for Forbidden {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        unsafe { an_allocation_is_reachable(layout.size()) }
    }

    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}
