// Starts the application.
import {App} from './app.js';
import {bigType} from './talk/big_type.js';
import {restoreTheme} from './theme.js';

restoreTheme();
bigType.show();
window.continua = new App(document.getElementById('page'));
