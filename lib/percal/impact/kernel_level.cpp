// The element kernel: see impact/.
