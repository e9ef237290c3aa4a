/* Empty code that claims to change a value: compilers must have it in a register at this point, and use that from here on. It
   makes no instruction, and no bit depends on it. Without it they load rows and numbers again, or load what many terms need
   ahead of the first, until the sums no longer fit into registers: the same results, in up to a third more instructions. */
$held