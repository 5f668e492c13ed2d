// Imported first: colours are those of the screen throughout, and are not converted.
import {ColorManagement} from 'three';

ColorManagement.enabled = false;
